package org.robotui.entity.grid.internal.display;

import java.util.List;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Places;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;

/** Lines in a plane. */
final class GridDisplay implements Display {
  private Optional<Made> made = Optional.empty();

  /** The lines, and what they were made by. */
  private record Made(long cells, double cell, float width, LineSet lines) {}

  @Override
  public DisplayResult update(DisplayTick tick) {
    Settings s = tick.settings();
    return switch (FrameChoice.place(tick.places(), s.text("frame"))) {
      case Places.Place.Missing missing -> DisplayResult.nothing(new DisplayStatus.NoFrame(missing.reason()));
      case Places.Place.At at -> {
        RigidTransform place = at.fixedFromFrame().times(new RigidTransform(
            new Vector3(s.number("x"), s.number("y"), s.number("z")), turn(s.text("plane"))));
        Part part = new Part("grid", lines(s), place, Material.flat(ColorSetting.read(s, "color")),
            Describer.of("grid of " + s.number("cell") + " m"));
        DisplayStatus shown = new DisplayStatus.Shown(s.integer("cells") + " cells of " + s.number("cell") + " m");
        yield new DisplayResult(List.of(part),
            ColorSetting.complaint(s).<DisplayStatus>map(DisplayStatus.Partly::new).orElse(shown), 0);
      }
    };
  }

  @Override
  public void close() {
    made = Optional.empty();
  }

  private LineSet lines(Settings s) {
    long cells = s.integer("cells");
    double cell = s.number("cell");
    float width = (float) s.number("width");
    if (made.filter(m -> m.cells == cells && m.cell == cell && m.width == width).isEmpty()) {
      made = Optional.of(new Made(cells, cell, width, build((int) cells, cell, width)));
    }
    return made.orElseThrow().lines();
  }

  private static LineSet build(int cells, double cell, float width) {
    float[] xyz = new float[12 * (cells + 1)];
    float end = (float) (cells * cell / 2);
    for (int i = 0; i <= cells; i++) {
      float at = (float) (i * cell) - end;
      float[] pair = {at, -end, 0, at, end, 0, -end, at, 0, end, at, 0};
      System.arraycopy(pair, 0, xyz, 12 * i, pair.length);
    }
    return LineSet.of(LineSet.Kind.SEGMENTS, width, xyz);
  }

  private static Quaternion turn(String plane) {
    return switch (plane) {
      case "xz" -> Quaternion.fromRollPitchYaw(Math.PI / 2, 0, 0);
      case "yz" -> Quaternion.fromRollPitchYaw(0, Math.PI / 2, 0);
      default -> Quaternion.IDENTITY;
    };
  }
}
