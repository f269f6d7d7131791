package org.robotui.gl.internal.draw;

import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import org.robotui.gl.shape.TriangleMesh;

/**
 * A mesh in several finenesses over the same corners. In a coarser one, all corners within a cell of a grid are drawn
 * at one of them: what is smaller than a pixel costs software as much as what is seen.
 */
final class Levels {
  private static final int CORNERS = 3;
  /** A level that has not so many triangles fewer than the one before is not worth its memory. */
  private static final double WORTH = 0.7;
  /** Meshes with fewer triangles are drawn as they are. */
  private static final int FEW = 500;
  private static final int MOST = 8;
  private static final double STEP = 1.5;
  /** Cells across the mesh, where they are so few that nothing of it would be left. */
  private static final int ROUGHEST = 12;

  /**
   * One of them.
   *
   * @param first index in the buffer
   * @param count of indices
   * @param error edge of a cell, within which corners are moved; metres
   */
  record Level(int first, int count, double error) {}

  private final List<Level> levels = new ArrayList<>();
  private final List<IntBuffer> triangles = new ArrayList<>();

  private Levels(TriangleMesh mesh) {
    add(mesh.triangles(), 0);
  }

  /** The mesh alone, as it is. */
  static Levels none(TriangleMesh mesh) {
    return new Levels(mesh);
  }

  /** Takes some milliseconds for a hundred thousand triangles. */
  static Levels of(TriangleMesh mesh) {
    Levels made = new Levels(mesh);
    mesh.bounds().ifPresent(bounds -> made.coarsen(mesh, 2 * bounds.radius()));
    return made;
  }

  private void coarsen(TriangleMesh mesh, double size) {
    double cell = Math.max(size / (1 << 16), Cells.spacing(mesh));
    while (cell < size / ROUGHEST && levels.size() < MOST && levels.getLast().count() > CORNERS * FEW) {
      IntBuffer fewer = new Cells(mesh, cell).merged(triangles.getLast());
      if (fewer.remaining() <= WORTH * levels.getLast().count()) {
        add(fewer, cell);
      }
      cell *= STEP;
    }
  }

  private void add(IntBuffer indices, double error) {
    int first = levels.isEmpty() ? 0 : levels.getLast().first() + levels.getLast().count();
    levels.add(new Level(first, indices.remaining(), error));
    triangles.add(indices);
  }

  /** The coarsest whose cells are no larger. */
  Level within(double metres) {
    Level best = levels.getFirst();
    for (Level level : levels) {
      if (level.error() <= metres) {
        best = level;
      }
    }
    return best;
  }

  /** The indices of all levels, one after the other. */
  IntBuffer indices() {
    IntBuffer all = IntBuffer.allocate(levels.getLast().first() + levels.getLast().count());
    triangles.forEach(some -> all.put(some.duplicate()));
    return all.flip();
  }
}
