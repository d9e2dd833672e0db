#pragma once

#include <map>
#include <string>
#include <vector>

#include "semantic_slam/worlds/furniture.h"

namespace semantic_slam {

// The kinds of each family; furniture.h has all of them in one list.
std::vector<FurnitureKind> SeatingKinds();
std::vector<FurnitureKind> TableKinds();
std::vector<FurnitureKind> StorageKinds();
std::vector<FurnitureKind> ShelfKinds();
std::vector<FurnitureKind> BedKinds();
std::vector<FurnitureKind> KitchenKinds();
std::vector<FurnitureKind> WallKinds();
std::vector<FurnitureKind> DoorKinds();
std::vector<FurnitureKind> OpeningKinds();
std::vector<FurnitureKind> ElectronicsKinds();
std::vector<FurnitureKind> LampKinds();
std::vector<FurnitureKind> PlantKinds();
std::vector<FurnitureKind> ReadingKinds();
std::vector<FurnitureKind> TablewareKinds();
std::vector<FurnitureKind> HouseholdKinds();
std::vector<FurnitureKind> PersonKinds();

// Designs 1, 2... of kinds by the kind's name; they are made of the materials of design 0. Those of
// a kind that has some in several families follow each other in the order of AllDesigns().
using DesignTable = std::map<std::string, std::vector<FurnitureDesign>>;

DesignTable ChairDesigns();
DesignTable OfficeChairDesigns();
DesignTable ArmchairDesigns();
DesignTable SofaDesigns();
DesignTable TableDesigns();
DesignTable DeskDesigns();
DesignTable StorageDesigns();
DesignTable ShelfDesigns();
DesignTable BedDesigns();
DesignTable LampDesigns();
DesignTable DoorDesigns();
DesignTable OpeningDesigns();
DesignTable WallDesigns();
DesignTable PlantDesigns();
DesignTable WoodenChairDesigns();
DesignTable StackableChairDesigns();
DesignTable SwivelChairDesigns();
DesignTable EasyChairDesigns();
DesignTable CouchDesigns();
DesignTable BedsteadDesigns();
DesignTable WorkstationDesigns();
DesignTable MeetingTableDesigns();
DesignTable LowTableDesigns();
DesignTable DiningTableDesigns();
DesignTable CupboardDesigns();

}  // namespace semantic_slam
