#pragma once

#include <string>

#include <semantic_slam/DetectionArray.h>
#include <semantic_slam/SemanticObjectArray.h>
#include <semantic_slam/TrackedObjectArray.h>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/detection/detections.h"
#include "semantic_slam/object_mapping/map_object.h"
#include "semantic_slam/object_tracking/object_tracks.h"

// Detections and objects as messages, and back. What reads a message throws
// semantic_slam::InputError with one line that names the fault if it is malformed or speaks of
// other labels than `vocabulary`.

namespace semantic_slam_ros {

semantic_slam::DetectionArray ToDetectionArray(const semantic_slam::Detections& detections,
                                               const std::string& frame_id);
// Refuses what CheckDetections() refuses, an image without size, and confidences that do not
// descend.
semantic_slam::Detections ToDetections(const semantic_slam::DetectionArray& msg,
                                       const semantic_slam::LabelVocabulary& vocabulary);

semantic_slam::TrackedObjectArray ToTrackedObjectArray(const semantic_slam::ObjectTracks& tracks,
                                                       const std::string& frame_id);
// Refuses boxes as ToDetections() does, unknown states, and ids that do not ascend.
semantic_slam::ObjectTracks ToObjectTracks(const semantic_slam::TrackedObjectArray& msg,
                                           const semantic_slam::LabelVocabulary& vocabulary);

semantic_slam::SemanticObject ToSemanticObject(const semantic_slam::MapObject& object);
semantic_slam::SemanticObjectArray ToSemanticObjectArray(const semantic_slam::ObjectMap& map,
                                                         const std::string& map_frame);
// Refuses another label set, labels or probabilities that are none, ids that do not ascend, numbers
// that are not finite, negative sizes and variances, and heights in the wrong order.
semantic_slam::ObjectMap ToObjectMap(const semantic_slam::SemanticObjectArray& msg,
                                     const semantic_slam::LabelVocabulary& vocabulary);

}  // namespace semantic_slam_ros
