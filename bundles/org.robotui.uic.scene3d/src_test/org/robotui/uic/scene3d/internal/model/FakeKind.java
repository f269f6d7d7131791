package org.robotui.uic.scene3d.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.DisplayType;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Rgba;
import org.robotui.geometry.RigidTransform;

/** A kind that shows one line for each value that came with the newest tick that brought some. */
public final class FakeKind implements DisplayType {
  public final List<DisplayTick> ticks = new ArrayList<>();
  public boolean throwing;
  public int open;
  public List<Part> parts = List.of();
  private final String id;
  private final List<Class<? extends Data>> accepts;

  public FakeKind(String id, List<Class<? extends Data>> accepts) {
    this.id = id;
    this.accepts = accepts;
  }

  @Override
  public String id() {
    return id;
  }

  @Override
  public String label() {
    return "Fake " + id;
  }

  @Override
  public String help() {
    return "For tests.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return accepts;
  }

  @Override
  public Set<Class<? extends Data>> needs() {
    return accepts.isEmpty() ? Set.of() : Set.of(accepts.getFirst());
  }

  @Override
  public boolean automatic() {
    return true;
  }

  @Override
  public Schema schema() {
    return Schema.of(
        Setting.of("size", new ValueType.Num(0, 10, "m"), 1.0, "How large."),
        Setting.of("style", new ValueType.Choice(List.of("flat", "round")), "flat", "How it looks."),
        Setting.of("color", new ValueType.Text(), "#4da3ff", "Its colour."),
        Setting.of("labels", new ValueType.Flag(), true, "Whether names are shown."));
  }

  @Override
  public Display create(DisplayContext context) {
    open++;
    return new Display() {
      {
        parts = accepts.isEmpty() ? List.of(line(0)) : List.of();
      }

      @Override
      public DisplayResult update(DisplayTick tick) {
        ticks.add(tick);
        if (throwing) {
          throw new IllegalStateException("the data bite");
        }
        if (!tick.arrived().isEmpty()) {
          parts = IntStream.range(0, tick.arrived().size()).mapToObj(FakeKind::line).toList();
        }
        return DisplayResult.shown(parts, parts.size() + " lines");
      }

      @Override
      public void close() {
        open--;
      }
    };
  }

  public static Part line(int number) {
    return new Part("line" + number, LineSet.of(LineSet.Kind.STRIP, 1, 0, 0, 0, 1, number, 0), RigidTransform.IDENTITY,
        Material.flat(Rgba.WHITE), Describer.of("Line " + number));
  }
}
