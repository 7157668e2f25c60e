#include "sample_office.h"

#include <cmath>

#include "FloorPlan.h"

namespace roomgraph {
namespace {

constexpr double kResolution = 0.05;
constexpr double kMargin = 1.2;    // around the rooms [m]
constexpr Point kStart{6.3, 6.3};  // of the robot, as seen from the lower left room's corner [m]

/** Metres from the inner corner of the lower left room. */
struct Area {
  double x0, y0, x1, y1;
};

constexpr Area kBuilding{-0.2, -0.2, 30.2, 20.2};

constexpr Area kFree[] = {
    // the ring corridor and the dead end that leaves it
    {5.4, 5.4, 24.6, 7.2},
    {5.4, 12.8, 24.6, 14.6},
    {5.4, 5.4, 7.2, 14.6},
    {22.8, 5.4, 24.6, 14.6},
    {24.6, 9.2, 29.6, 10.8},
    // rooms below, left to right, the last one L-shaped
    {0, 0, 7.2, 5.2},
    {7.4, 0, 13.0, 5.2},
    {13.2, 0, 20.6, 5.2},
    {20.8, 0, 24.6, 5.2},
    {24.8, 0, 30, 5.2},
    {27.4, 5.2, 30, 9.0},
    // to the right, above with the hall at the end, to the left
    {24.8, 11.0, 30, 14.6},
    {0, 14.8, 7.2, 20},
    {7.4, 14.8, 13.0, 20},
    {13.2, 14.8, 21.0, 20},
    {21.2, 14.8, 30, 20},
    {0, 5.4, 5.2, 9.4},
    {0, 9.6, 5.2, 14.6},
    // the core; its left third is closed
    {7.4, 7.4, 12.4, 12.6},
    {12.6, 7.4, 17.4, 12.6},
    {17.6, 7.4, 22.6, 12.6},
    // doors below
    {5.8, 5.2, 6.7, 5.4},
    {8.8, 5.2, 9.7, 5.4},
    {13.8, 5.2, 14.7, 5.4},
    {18.8, 5.2, 19.7, 5.4},
    {23.2, 5.2, 24.0, 5.4},
    {28.0, 9.0, 28.9, 9.2},
    // to the right, above, to the left
    {26.0, 10.8, 26.9, 11.0},
    {5.8, 14.6, 6.7, 14.8},
    {8.0, 14.6, 8.9, 14.8},
    {16.0, 14.6, 16.9, 14.8},
    {22.2, 14.6, 23.4, 14.8},
    {5.2, 7.0, 5.4, 7.9},
    {5.2, 11.0, 5.4, 11.9},
    // of the core
    {14.0, 7.2, 14.9, 7.4},
    {17.4, 10.6, 17.6, 11.5},
    {22.6, 9.6, 22.8, 10.5}};

constexpr Area kPillars[] = {
    {14.8, 9.7, 15.2, 10.1}, {24.6, 16.2, 25.0, 16.6}, {27.4, 16.2, 27.8, 16.6}};

constexpr Area kFurniture[] = {
    // desks
    {0, 4.0, 1.6, 4.8},
    {0, 0, 1.6, 0.8},
    {3.0, 0, 4.6, 0.8},
    {12.2, 2.4, 13.0, 4.0},
    {7.4, 0, 9.0, 0.8},
    {0, 18.4, 0.8, 20},
    {0, 14.8, 1.6, 15.6},
    {10.6, 19.2, 12.2, 20},
    {0, 5.4, 1.6, 6.2},
    {28.6, 13.8, 30, 14.6},
    {29.2, 0, 30, 1.6},
    {24.8, 0, 26.4, 0.8},
    // tables with room to walk round
    {15.6, 1.2, 18.0, 2.2},
    {3.0, 17.6, 4.8, 18.6},
    // shelves and cupboards
    {12.6, 8.6, 13.0, 12.2},
    {20.0, 7.4, 22.2, 7.8},
    {20.8, 0, 21.2, 3.2},
    {13.2, 17.4, 13.6, 20},
    {9.6, 14.1, 11.2, 14.6}};

constexpr Area kChairs[] = {{16.1, 2.7, 16.2, 2.8},   {17.3, 2.7, 17.4, 2.8},
                            {0.7, 1.2, 0.8, 1.3},     {3.7, 1.2, 3.8, 1.3},
                            {11.8, 3.1, 11.9, 3.2},   {1.2, 19.1, 1.3, 19.2},
                            {11.3, 18.7, 11.4, 18.8}, {4.0, 18.9, 4.1, 19.0}};

constexpr Point kTour[] = {
    {6.3, 6.3},   {6.2, 5.3},    {6.0, 3.0},   {3.0, 2.6},    {6.0, 3.0},    {6.2, 5.3},
    {6.5, 6.3},   {9.2, 6.3},    {9.25, 5.3},  {9.6, 3.0},    {11.3, 2.2},   {9.6, 3.0},
    {9.25, 5.3},  {9.3, 6.3},    {14.2, 6.3},  {14.25, 5.3},  {14.6, 3.2},   {19.0, 3.2},
    {19.25, 5.3}, {19.2, 6.3},   {14.5, 6.4},  {14.45, 7.3},  {14.0, 8.8},   {14.0, 11.0},
    {16.4, 11.0}, {17.5, 11.0},  {19.2, 10.4}, {21.5, 10.0},  {22.7, 10.05}, {23.7, 10.0},
    {23.7, 6.4},  {23.6, 5.3},   {22.8, 2.8},  {23.6, 5.3},   {23.7, 6.4},   {23.7, 10.0},
    {26.4, 10.0}, {26.45, 10.9}, {26.8, 12.8}, {26.45, 10.9}, {26.5, 10.0},  {28.4, 10.0},
    {28.45, 9.1}, {28.6, 7.0},   {28.4, 2.9},  {26.5, 2.5},   {28.4, 2.9},   {28.6, 7.0},
    {28.45, 9.1}, {28.3, 10.0},  {23.7, 10.0}, {23.6, 13.6},  {22.8, 14.7},  {22.9, 17.4},
    {26.1, 17.9}, {28.8, 17.4},  {28.8, 15.5}, {23.2, 15.6},  {22.8, 14.7},  {22.5, 13.7},
    {16.5, 13.7}, {16.45, 14.7}, {16.8, 17.0}, {19.2, 17.2},  {16.8, 17.0},  {16.45, 14.7},
    {16.3, 13.6}, {8.6, 13.6},   {8.45, 14.7}, {9.0, 17.0},   {11.2, 17.0},  {9.0, 17.0},
    {8.45, 14.7}, {8.3, 13.7},   {6.4, 13.7},  {6.25, 14.7},  {5.6, 16.8},   {2.4, 16.7},
    {5.6, 16.8},  {6.25, 14.7},  {6.3, 13.6},  {6.3, 7.5},    {5.3, 7.45},   {2.8, 7.4},
    {5.3, 7.45},  {6.3, 7.3},    {6.3, 6.3}};

int cells(double metres) { return int(std::lround((metres + kMargin) / kResolution)); }

CellBox cellsOf(const Area& area) {
  return {cells(area.x0), cells(area.y0), cells(area.x1), cells(area.y1)};
}

}  // namespace

SampleOffice sampleOffice() {
  FloorPlan plan(cells(30 + kMargin), cells(20 + kMargin), kResolution,
                 {-kStart.x - kMargin, -kStart.y - kMargin});
  plan.fill(cellsOf(kBuilding), grey::kWall);
  for (const Area& area : kFree) plan.fill(cellsOf(area), grey::kFree);
  for (const Area& area : kPillars) plan.fill(cellsOf(area), grey::kWall);
  for (const Area& area : kFurniture) plan.putFurniture(cellsOf(area));
  for (const Area& area : kChairs) plan.fill(cellsOf(area), grey::kWall);
  SampleOffice office;
  office.map = std::move(plan).take();
  for (const Point& corner : kTour) office.tour.push_back(corner - kStart);
  return office;
}

}  // namespace roomgraph
