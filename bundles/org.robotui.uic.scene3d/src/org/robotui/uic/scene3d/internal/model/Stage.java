package org.robotui.uic.scene3d.internal.model;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.display.ColorScale;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Rgba;
import org.robotui.ui.display.DisplayRow;

/**
 * What a tick made: all that views and renderers need, immutable.
 *
 * @param version another one where another picture is to be made
 * @param parts by id of display
 * @param rows the displays as listed
 * @param fixed the frame that is drawn at rest; none while no frame is known
 * @param frames all that could be chosen instead
 * @param robots where they are, in the order in which they were seen
 * @param dropped values lost to full queues, or not shown
 * @param colors what colours mean, of the first display first
 */
public record Stage(long version, Map<Object, List<Part>> parts, List<DisplayRow> rows, Optional<FrameId> fixed,
    List<FrameId> frames,
    List<Robot> robots, long dropped, List<ColorScale> colors) {
  /** Before the first tick. */
  public static final Stage NONE = new Stage(0, Map.of(), List.of(), Optional.empty(), List.of(), List.of(), 0);

  /** Without colours that mean numbers. */
  public Stage(long version, Map<Object, List<Part>> parts, List<DisplayRow> rows, Optional<FrameId> fixed,
      List<FrameId> frames, List<Robot> robots, long dropped) {
    this(version, parts, rows, fixed, frames, robots, dropped, List.of());
  }

  /**
   * A robot in the scene.
   *
   * @param name of it
   * @param color of it
   * @param fixedFromBase where it is, if known
   */
  public record Robot(String name, Rgba color, Optional<RigidTransform> fixedFromBase) {}

  /** Where what came from robots lies: not the kinds without data, for example a grid. */
  public Optional<Box3> fed() {
    Set<Object> fed =
        rows.stream().filter(r -> !r.choices().isEmpty()).map(r -> r.spec().id()).collect(Collectors.toSet());
    return box(parts.entrySet().stream().filter(e -> fed.contains(e.getKey())).flatMap(e -> e.getValue().stream()));
  }

  /** What is looked at when all is to be seen. */
  public Optional<Box3> bounds() {
    return fed().or(this::everything);
  }

  /** Where all that is shown lies. */
  public Optional<Box3> everything() {
    return box(parts.values().stream().flatMap(List::stream));
  }

  /** Where one display lies. */
  public Optional<Box3> bounds(Object display) {
    return box(parts.getOrDefault(display, List.of()).stream());
  }

  /** Memory of all shapes, bytes. */
  public long bytes() {
    return rows.stream().mapToLong(DisplayRow::bytes).sum();
  }

  /** Whether something can be moved by hand. */
  public boolean handled() {
    return parts.values().stream().flatMap(List::stream).anyMatch(p -> p.handle().isPresent());
  }

  private static Optional<Box3> box(Stream<Part> parts) {
    return parts.flatMap(p -> p.bounds().stream()).reduce(Box3::union);
  }
}
