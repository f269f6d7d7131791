package org.robotui.tests.novelty;

import java.util.List;
import java.util.Optional;
import org.robotui.api.config.Schema;
import org.robotui.data.Data;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.display.Anchor;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.DisplayType;
import org.robotui.gl.display.Recent;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.TriangleMesh;

/** Depths in space: an arrow at the sounder. */
final class DepthDisplayType implements DisplayType {
  /** Nothing else in a window has this colour. */
  static final int RGB = 0xff00ff;

  @Override
  public String id() {
    return "depth";
  }

  @Override
  public String label() {
    return "Depth";
  }

  @Override
  public String help() {
    return "Shows where the depth of water was measured.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(WaterDepth.class);
  }

  @Override
  public Schema schema() {
    return Schema.EMPTY;
  }

  @Override
  public Display create(DisplayContext context) {
    return new Arrow();
  }

  private static final class Arrow implements Display {
    private final TriangleMesh mesh = Meshes.arrow(2, 1, 2, 2);
    private final Recent<WaterDepth, TriangleMesh> recent =
        new Recent<>(WaterDepth.class, Anchor.When.NOW, WaterDepth::frame, depth -> 1);

    @Override
    public DisplayResult update(DisplayTick tick) {
      recent.update(tick);
      Optional<RigidTransform> place = recent.newest().flatMap(entry -> entry.anchor().found());
      List<Part> parts = place.stream().map(this::part).toList();
      return new DisplayResult(parts, recent.status(tick, new DisplayStatus.Shown("")), recent.dropped());
    }

    private Part part(RigidTransform place) {
      return new Part("arrow", mesh, place, Material.flat(Rgba.of(RGB)), (element, at) -> Properties.of("Depth"));
    }

    @Override
    public void close() {
      recent.clear();
    }
  }
}
