package org.robotui.uic.scene3d.internal.model;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.robotui.api.UicContext;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.Places;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Placings;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Shape;
import org.robotui.ui.scene.PastSpot;
import org.robotui.ui.scene.PastWays;
import org.robotui.uic.scene3d.internal.ScenePorts;

/**
 * Where recorded robots were at the time at which the user points: an arrow in a ring, on the way that the robot went.
 * The frames of odometry and estimates are where they are now, as for trails. Worker thread.
 */
final class PastLook {
  /** What the parts of this look are kept by. */
  static final String DISPLAY = "#past";

  private static final List<String> TYPES = List.of("Odometry", "PoseEstimate");
  private static final double LENGTH = 0.5;
  private static final double THIN = 0.08;
  private static final double RING = 0.3;
  private static final int CORNERS = 48;
  private static final float WIDTH = 2;
  private static final float BROAD = 3;
  private static final float PALE = 0.7f;
  private static final RigidTransform LIFT = new RigidTransform(new Vector3(0, 0, 0.03), Quaternion.IDENTITY);

  private final Input<Data> input;
  private final PastWays ways;
  private final Shape arrow = new Placings(1)
      .add(RigidTransform.IDENTITY, new Vector3(LENGTH, THIN * LENGTH, THIN * LENGTH)).of(Meshes.arrow());
  private final Shape ring = LineSet.of(LineSet.Kind.STRIP, BROAD, circle());
  private final Map<String, Line> lines = new HashMap<>();

  /** A way, and what was made of it. */
  private record Line(List<Vector3> way, LineSet shape) {}

  PastLook(UicContext context) {
    input = context.input(ScenePorts.DATA);
    ways = new PastWays(context.pointed(), context.background());
  }

  List<Part> parts(Places places, Function<String, Rgba> colors) {
    Map<String, PastSpot> spots = ways.spots(input, sources());
    List<Part> parts = new ArrayList<>();
    spots.forEach((robot, spot) -> places.at(spot.frame(), Optional.empty()).found().ifPresent(place -> {
      Rgba color = colors.apply(robot);
      RigidTransform ground = place.times(LIFT);
      parts.add(new Part("way " + robot, line(robot, spot.way()), ground, Material.flat(color.withAlpha(PALE)),
          Describer.of("Way of " + robot + " in the recording")));
      RigidTransform then = ground.times(spot.pose());
      Describer words = Describer.of(robot + " at the time of the pointer");
      parts.add(new Part("then " + robot, arrow, then, Material.lit(color).onTop(), words));
      parts.add(new Part("around " + robot, ring, then, Material.flat(color).onTop(), words));
    }));
    return parts;
  }

  private List<SourceId> sources() {
    return input.candidates().stream().filter(each -> TYPES.contains(each.typeName()))
        .sorted(Comparator.comparing(each -> TYPES.indexOf(each.typeName()))).map(Input.Candidate::id).toList();
  }

  private LineSet line(String robot, List<Vector3> way) {
    return lines.compute(robot, (name, before) -> before != null && before.way() == way ? before : made(way)).shape();
  }

  private static List<Vector3> circle() {
    return IntStream.rangeClosed(0, CORNERS).mapToDouble(i -> 2 * Math.PI * i / CORNERS)
        .mapToObj(angle -> new Vector3(RING * Math.cos(angle), RING * Math.sin(angle), 0)).toList();
  }

  private static Line made(List<Vector3> way) {
    return new Line(way, LineSet.of(LineSet.Kind.STRIP, WIDTH, way));
  }
}
