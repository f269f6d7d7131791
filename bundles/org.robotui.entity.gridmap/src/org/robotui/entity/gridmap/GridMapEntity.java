package org.robotui.entity.gridmap;

import java.util.Optional;
import org.robotui.data.navigation.GridMap;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Figures;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Entity;
import org.robotui.ui.scene.Painter;

/**
 * A grid map. Preparing builds a pyramid of ever coarser maps once per map; painting takes the level that suits the
 * zoom, and of that the tiles that are seen.
 */
public final class GridMapEntity implements Entity {
  private static final int FREE_BELOW = 25;
  private static final int OCCUPIED_FROM = 65;

  private record Prepared(Pyramid pyramid, RigidTransform fixedFromGrid, Bounds bounds) {}

  private final TilePainter tiles = new TilePainter();
  private volatile double opacity = 1;
  private volatile Optional<Prepared> prepared = Optional.empty();

  /** Without a map. */
  public GridMapEntity() {
    // The first map comes with prepare.
  }

  /**
   * How opaque it is painted. Any thread.
   *
   * @param share 0 to 1; 1 at the beginning
   */
  public void opacity(double share) {
    opacity = share;
  }

  /**
   * Takes a map. The same object as before costs nothing but the new place. Worker thread, one at a time.
   *
   * @param map the map
   * @param fixedFromMap fixed frame from the frame of the map
   */
  public void prepare(GridMap map, RigidTransform fixedFromMap) {
    Pyramid pyramid = prepared.map(Prepared::pyramid).filter(p -> p.map() == map).orElseGet(() -> Pyramid.of(map));
    RigidTransform fixedFromGrid = fixedFromMap.times(map.origin());
    prepared = Optional.of(new Prepared(pyramid, fixedFromGrid, bounds(map, fixedFromGrid)));
  }

  @Override
  public void paint(Painter painter) {
    prepared.ifPresent(p -> tiles.paint(painter.opacity(opacity), p.pyramid(), p.fixedFromGrid()));
    painter.opacity(1);
  }

  @Override
  public Optional<Bounds> bounds() {
    return prepared.map(Prepared::bounds);
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return prepared.flatMap(p -> describe(p, x, y));
  }

  @Override
  public void dispose() {
    tiles.dispose();
  }

  private static Optional<Description> describe(Prepared p, double x, double y) {
    GridMap map = p.pyramid().map();
    Vector3 inGrid = p.fixedFromGrid().inverse().apply(new Vector3(x, y, p.fixedFromGrid().translation().z()));
    int column = (int) Math.floor(inGrid.x() / map.resolution());
    int row = (int) Math.floor(inGrid.y() / map.resolution());
    if (column < 0 || row < 0 || column >= map.width() || row >= map.height()) {
      return Optional.empty();
    }
    return word(map.cell(column, row)).map(word -> new Description("map: " + word, 0));
  }

  private static Optional<String> word(int occupancy) {
    if (occupancy < 0) {
      return Optional.empty();
    }
    if (occupancy < FREE_BELOW) {
      return Optional.of("free");
    }
    String share = Figures.of(occupancy, 0, "%");
    return Optional.of(occupancy < OCCUPIED_FROM ? "perhaps occupied, " + share : "occupied, " + share);
  }

  private static Bounds bounds(GridMap map, RigidTransform fixedFromGrid) {
    double width = map.width() * map.resolution();
    double height = map.height() * map.resolution();
    return corner(fixedFromGrid, 0, 0)
        .union(corner(fixedFromGrid, width, 0))
        .union(corner(fixedFromGrid, 0, height))
        .union(corner(fixedFromGrid, width, height));
  }

  private static Bounds corner(RigidTransform fixedFromGrid, double x, double y) {
    Vector3 corner = fixedFromGrid.apply(new Vector3(x, y, 0));
    return Bounds.around(corner.x(), corner.y(), 0);
  }
}
