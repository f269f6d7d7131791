package org.robotui.entity.gridmap.internal.display;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.data.navigation.GridMap;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.Anchor;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Recent;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Properties;

/** The newest map, in tiles. */
final class GridMapDisplay implements Display {
  private final Recent<GridMap, Object> recent = new Recent<>(GridMap.class, Anchor.When.NOW, GridMap::frame, map -> 1);
  private final Tiles tiles = new Tiles();

  @Override
  public DisplayResult update(DisplayTick tick) {
    recent.update(tick);
    Optional<GridMap> map = recent.newest().map(Recent.Entry::value);
    List<Part> parts = new ArrayList<>();
    recent.newest().flatMap(entry -> entry.anchor().found())
        .ifPresent(place -> add(parts, map.orElseThrow(), place, tick));
    if (map.isEmpty()) {
      tiles.clear();
    }
    return new DisplayResult(parts,
        recent.status(tick, map.map(this::status).orElseGet(() -> new DisplayStatus.NoData(""))), 0);
  }

  @Override
  public void close() {
    recent.clear();
    tiles.clear();
  }

  private void add(List<Part> parts, GridMap map, RigidTransform place, DisplayTick tick) {
    Settings s = tick.settings();
    RigidTransform lifted = place.times(map.origin())
        .times(new RigidTransform(new Vector3(0, 0, s.number("height")), Quaternion.IDENTITY));
    double opacity = s.number("opacity") * Recent.opacity(tick);
    Describer describer = (element, at) -> describe(map, at);
    tiles.update(map, new Tiles.Look(s.text("scheme"), s.flag("unknown"))).forEach((key, tile) -> parts
        .add(new Part(key, tile.mesh(), lifted, Material.picture(tile.texture(), opacity), describer)));
  }

  private DisplayStatus status(GridMap map) {
    String words = String.format(Locale.ROOT, "%d x %d cells of %.3g m", map.width(), map.height(), map.resolution());
    return tiles.coarse() == 1
        ? new DisplayStatus.Shown(words)
        : new DisplayStatus.Partly(words + ", drawn " + tiles.coarse() + " times coarser: too many cells");
  }

  private static Properties describe(GridMap map, Vector3 at) {
    int column = (int) Math.floor(at.x() / map.resolution());
    int row = (int) Math.floor(at.y() / map.resolution());
    if (column < 0 || row < 0 || column >= map.width() || row >= map.height()) {
      return Properties.of("grid map");
    }
    byte value = map.cell(column, row);
    return Properties.of("cell " + column + ", " + row,
        new Properties.Entry("frame", map.frame().name()),
        new Properties.Entry("occupancy", value == GridMap.UNKNOWN ? "unknown" : (value & 0xff) + " %"),
        new Properties.Entry("edge", String.format(Locale.ROOT, "%.3g m", map.resolution())));
  }
}
