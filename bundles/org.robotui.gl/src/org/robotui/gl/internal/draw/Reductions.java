package org.robotui.gl.internal.draw;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;
import org.robotui.gl.internal.splat.Facets;
import org.robotui.gl.shape.TriangleMesh;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Levels of detail of a mesh that are made in the background, one an octave of distances: as many triangles as its
 * shape needs, where {@link Levels} have as many as its area has pixels. Used on the thread of OpenGL.
 */
final class Reductions {
  private static final Logger LOG = LoggerFactory.getLogger(Reductions.class);
  /** Of the corners' own tolerance: how far the surface may move. Half a pixel, and less until the next octave. */
  private static final double TOLERANCE = 0.5;
  /** Across a mesh: one that is nearer reaches far beyond the picture, and is drawn as it is. */
  private static final double MOST_PIXELS = 4096;
  /** Triangles that take less time than it would take to think about them. */
  private static final int FEW = 300;

  private final TriangleMesh mesh;
  private final Levels levels;
  private final double finest;
  private final Map<Integer, Future<Optional<Facets>>> byOctave = new HashMap<>();
  private int newest;

  Reductions(TriangleMesh mesh, Levels levels) {
    this.mesh = mesh;
    this.levels = levels;
    finest = mesh.bounds().filter(box -> mesh.elements() >= FEW).map(box -> 2 * box.radius() / MOST_PIXELS)
        .orElse(Double.POSITIVE_INFINITY);
  }

  /**
   * One whose corners may be elsewhere by so much.
   *
   * @param metres what is not seen
   * @param background where it is made
   * @return none while it is being made, from very near, and of a mesh that has few triangles anyway
   */
  Optional<Facets> within(double metres, ExecutorService background) {
    int octave = Math.getExponent(metres);
    if (!(Math.scalb(1.0, octave) > finest)) {
      return Optional.empty();
    }
    Future<Optional<Facets>> made = byOctave.get(octave);
    if (made == null) {
      leaveUnfinished();
      made = background.submit(() -> make(octave));
      byOctave.put(octave, made);
      newest = octave;
    }
    return made.state() == Future.State.SUCCESS ? made.resultNow() : Optional.empty();
  }

  /** A camera that comes nearer passes through octaves that it does not need any more. */
  private void leaveUnfinished() {
    Future<Optional<Facets>> last = byOctave.get(newest);
    if (last != null && last.cancel(true)) {
      byOctave.remove(newest);
    }
  }

  private Optional<Facets> make(int octave) {
    try {
      double metres = Math.scalb(1.0, octave);
      Levels.Level level = levels.within(metres);
      return Facets.of(mesh, levels.indices().slice(level.first(), level.count()))
          .map(facets -> facets.reduced(TOLERANCE * metres, Thread.currentThread()::isInterrupted));
    } catch (RuntimeException e) {
      LOG.warn("A mesh of {} triangles is drawn with all of them", mesh.elements(), e);
      return Optional.empty();
    }
  }

  /** Nobody needs it any more. */
  void close() {
    byOctave.values().forEach(some -> some.cancel(true));
  }
}
