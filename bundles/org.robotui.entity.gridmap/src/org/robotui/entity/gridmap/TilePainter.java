package org.robotui.entity.gridmap;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.swt.graphics.Image;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Theme;
import org.robotui.ui.scene.Painter;

/**
 * Paints the tiles of a level that are seen and keeps their images. New images take a bounded time per paint; the rest
 * follows with the next one, and until all are there the coarsest level is seen instead. Display thread only.
 */
final class TilePainter {
  static final int EDGE = 256;
  private static final int KEPT = 300;
  private static final long BUDGET_NANOS = 5_000_000;

  private record Key(int level, int column, int row) {}

  private record Source(Pyramid pyramid, Theme theme) {}

  private final Map<Key, Optional<Image>> images = new LinkedHashMap<>(64, 0.75f, true);
  private Optional<Source> source = Optional.empty();
  private Optional<Tint> tint = Optional.empty();

  void paint(Painter painter, Pyramid pyramid, RigidTransform fixedFromGrid) {
    from(new Source(pyramid, painter.theme()));
    int suited = pyramid.suited(pyramid.map().resolution() * painter.viewport().scale());
    int coarsest = pyramid.levels().size() - 1;
    boolean complete = make(painter, pyramid, seen(painter, pyramid, fixedFromGrid, suited));
    if (complete || suited == coarsest) {
      paint(painter, pyramid, fixedFromGrid, seen(painter, pyramid, fixedFromGrid, suited));
    } else {
      List<Key> small = seen(painter, pyramid, fixedFromGrid, coarsest);
      make(painter, pyramid, small);
      paint(painter, pyramid, fixedFromGrid, small);
    }
    forgetOldest();
  }

  void dispose() {
    images.values().forEach(i -> i.ifPresent(Image::dispose));
    images.clear();
    source = Optional.empty();
  }

  private void from(Source wanted) {
    if (!source.equals(Optional.of(wanted))) {
      dispose();
      source = Optional.of(wanted);
      tint = Optional.of(new Tint(wanted.theme().palette()));
    }
  }

  private static List<Key> seen(Painter painter, Pyramid pyramid, RigidTransform fixedFromGrid, int level) {
    TileRange range = TileRange.seen(pyramid, level, fixedFromGrid, painter.viewport().visible());
    List<Key> keys = new ArrayList<>();
    for (int row = range.firstRow(); row <= range.lastRow(); row++) {
      for (int column = range.firstColumn(); column <= range.lastColumn(); column++) {
        keys.add(new Key(level, column, row));
      }
    }
    return keys;
  }

  /** Makes missing images as long as there is time, at least one. */
  private boolean make(Painter painter, Pyramid pyramid, List<Key> keys) {
    long deadline = System.nanoTime() + BUDGET_NANOS;
    for (Key key : keys) {
      if (!images.containsKey(key)) {
        images.put(key, image(painter, pyramid.levels().get(key.level()), key));
        if (System.nanoTime() > deadline) {
          break;
        }
      }
    }
    boolean complete = images.keySet().containsAll(keys);
    if (!complete) {
      painter.paintAgain();
    }
    return complete;
  }

  private void paint(Painter painter, Pyramid pyramid, RigidTransform fixedFromGrid, List<Key> keys) {
    for (Key key : keys) {
      Optional.ofNullable(images.get(key)).flatMap(i -> i).ifPresent(image -> {
        double size = pyramid.map().resolution() * pyramid.levels().get(key.level()).factor();
        Vector3 corner = new Vector3(key.column() * EDGE * size, key.row() * EDGE * size, 0);
        RigidTransform place = new RigidTransform(fixedFromGrid.apply(corner), fixedFromGrid.rotation());
        painter.image(image, place, size);
      });
    }
  }

  private Optional<Image> image(Painter painter, Level level, Key key) {
    int left = key.column() * EDGE;
    int low = key.row() * EDGE;
    int width = Math.min(EDGE, level.width() - left);
    int height = Math.min(EDGE, level.height() - low);
    if (unknown(level, left, low, width, height)) {
      return Optional.empty();
    }
    return tint.map(t -> new Image(painter.gc().getDevice(), t.image(level, left, low, width, height)));
  }

  private static boolean unknown(Level level, int left, int low, int width, int height) {
    for (int y = low; y < low + height; y++) {
      for (int x = left; x < left + width; x++) {
        if (level.cells().get(y * level.width() + x) >= 0) {
          return false;
        }
      }
    }
    return true;
  }

  private void forgetOldest() {
    Iterator<Optional<Image>> oldest = images.values().iterator();
    while (images.size() > KEPT && oldest.hasNext()) {
      oldest.next().ifPresent(Image::dispose);
      oldest.remove();
    }
  }
}
