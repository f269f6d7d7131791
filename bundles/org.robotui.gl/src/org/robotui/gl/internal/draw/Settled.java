package org.robotui.gl.internal.draw;

import java.nio.IntBuffer;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.gl.internal.draw.Levels.Level;
import org.robotui.gl.internal.splat.FacetBrush;
import org.robotui.gl.internal.splat.FacetPainter;
import org.robotui.gl.internal.splat.Facets;
import org.robotui.gl.internal.splat.Splats;
import org.robotui.gl.shape.TriangleMesh;

/**
 * What is known of a mesh that has stayed the same for some pictures: coarser forms of it, and what of it may be left
 * out.
 */
final class Settled {
  private static final int CORNERS = 3;
  /** Pixels of a triangle, as a mean. What is larger is lit pixel by pixel by OpenGL, which is as quick with it. */
  private static final double LARGE = 250;
  /** The same of triangles that have one light all over. */
  private static final double LARGE_FLAT = 20_000;

  private final TriangleMesh mesh;
  private final Levels levels;
  private final double openness;
  private final double large;
  private final Reductions reductions;
  private final Map<Level, Optional<Facets>> facets = new HashMap<>();

  /** Takes some milliseconds for a hundred thousand triangles. */
  Settled(TriangleMesh mesh) {
    this.mesh = mesh;
    levels = Levels.of(mesh);
    reductions = new Reductions(mesh, levels);
    openness = Solid.openness(mesh);
    large = Flatness.isFlat(mesh) ? LARGE_FLAT : LARGE;
  }

  /** The indices of all levels, one after the other. */
  IntBuffer indices() {
    return levels.indices();
  }

  /** The level that is drawn. */
  Level now(Pass pass, DrawState look) {
    return levels.within(pass.fineness().pixels() * pass.metresPerPixel(look, mesh.bounds()));
  }

  /** How many of its triangles are left out while the camera moves. */
  int leftOut(Pass pass, DrawState look, Level now) {
    Level rest = levels.within(Fineness.AT_REST.pixels() * pass.metresPerPixel(look, mesh.bounds()));
    return Math.max(0, rest.count() - now.count()) / CORNERS;
  }

  /** Whether triangles that face away are hidden by others. */
  boolean hidesBacks(Pass pass) {
    return openness <= pass.fineness().openness();
  }

  /** Paints it into splats, where its triangles are small and all of it is ahead of the eye; answers whether it did. */
  boolean paint(Pass pass, DrawState look, Splats splats) {
    Level level = now(pass, look);
    if (isLarge(level, pass.metresPerPixel(look, mesh.bounds()))
        || mesh.bounds().filter(box -> Clip.holds(look.clipFromShape(), box)).isEmpty()) {
      return false;
    }
    Optional<Facets> painted =
        reductions.within(pass.fineness().pixels() * pass.metresPerPixel(look, mesh.bounds()), pass.workers())
            .or(() -> facets.computeIfAbsent(level, l -> Facets.of(mesh, indices(l))));
    painted.ifPresent(some -> {
      new FacetPainter(splats, brush(pass, look), some).paint(pass.givenUp());
      pass.tally().triangles(some.count(), leftOut(pass, look, level));
    });
    return painted.isPresent();
  }

  /** It is drawn no more. */
  void close() {
    reductions.close();
  }

  private boolean isLarge(Level level, double metresPerPixel) {
    double edge = mesh.bounds().map(box -> 2 * box.radius()).orElse(0.0) / metresPerPixel;
    return !(edge * edge < large * level.count() / CORNERS);
  }

  private IntBuffer indices(Level level) {
    return levels.indices().slice(level.first(), level.count());
  }

  private FacetBrush brush(Pass pass, DrawState look) {
    return new FacetBrush(look.clipFromShape().floats(), look.eyeFromShape().floats(), pass.up(), look.lit(),
        look.color(),
        pass.glow(look), (float) look.near(), (float) look.far(), hidesBacks(pass));
  }
}
