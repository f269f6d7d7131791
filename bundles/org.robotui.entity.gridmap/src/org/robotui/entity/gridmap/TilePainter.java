package org.robotui.entity.gridmap;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.eclipse.swt.graphics.Image;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Theme;
import org.robotui.ui.scene.Painter;

/**
 * Paints the tiles of a level that are seen and keeps their images. New images take a bounded time per paint; what is missing
 * then follows with the next paint, and until then a coarser level is seen below. Display thread only.
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
    long deadline = System.nanoTime() + BUDGET_NANOS;
    if (suited != coarsest && !complete(painter, pyramid, fixedFromGrid, suited)) {
      paint(painter, pyramid, fixedFromGrid, coarsest, Long.MAX_VALUE);
    }
    paint(painter, pyramid, fixedFromGrid, suited, deadline);
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

  private boolean complete(Painter painter, Pyramid pyramid, RigidTransform fixedFromGrid, int index) {
    TileRange range = TileRange.seen(pyramid, index, fixedFromGrid, painter.viewport().visible());
    for (int row = range.firstRow(); row <= range.lastRow(); row++) {
      for (int column = range.firstColumn(); column <= range.lastColumn(); column++) {
        if (!images.containsKey(new Key(index, column, row))) {
          return false;
        }
      }
    }
    return true;
  }

  private void paint(Painter painter, Pyramid pyramid, RigidTransform fixedFromGrid, int index, long deadline) {
    TileRange range = TileRange.seen(pyramid, index, fixedFromGrid, painter.viewport().visible());
    for (int row = range.firstRow(); row <= range.lastRow(); row++) {
      for (int column = range.firstColumn(); column <= range.lastColumn(); column++) {
        paintTile(painter, pyramid, fixedFromGrid, new Key(index, column, row), deadline);
      }
    }
  }

  private void paintTile(Painter painter, Pyramid pyramid, RigidTransform fixedFromGrid, Key key, long deadline) {
    if (!images.containsKey(key)) {
      if (System.nanoTime() > deadline) {
        painter.paintAgain();
        return;
      }
      images.put(key, make(painter, pyramid.levels().get(key.level()), key));
    }
    images.get(key).ifPresent(image -> {
      double size = pyramid.map().resolution() * pyramid.levels().get(key.level()).factor();
      Vector3 corner = new Vector3(key.column() * EDGE * size, key.row() * EDGE * size, 0);
      RigidTransform place = new RigidTransform(fixedFromGrid.apply(corner), fixedFromGrid.rotation());
      painter.image(image, place, size);
    });
  }

  private Optional<Image> make(Painter painter, Level level, Key key) {
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
