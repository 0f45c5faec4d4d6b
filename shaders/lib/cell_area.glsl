// The surface that a cell of the irradiance grid has.                                                          [I3]
#ifndef LAMPYRIS_LIB_CELL_AREA
#define LAMPYRIS_LIB_CELL_AREA
#include "shared/irradiance_grid.h"

// Photons that fell on a sliver which no column met spread over most of a column: dim, never a spark.
float cellMetres2(GridParams grid, uint areaWord) {
    float columns = float(max(areaWord, 3u * GRID_AREA_UNITS / 4u)) / float(GRID_AREA_UNITS);
    return grid.offsetCell.w * grid.offsetCell.w * columns / float(grid.columns);
}

#endif
