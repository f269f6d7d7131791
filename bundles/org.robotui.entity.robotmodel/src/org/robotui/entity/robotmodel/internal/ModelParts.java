package org.robotui.entity.robotmodel.internal;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.robotui.api.config.Settings;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Label;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.TriangleMesh;
import org.robotui.urdf.Link;
import org.robotui.urdf.SemanticModel;

/** Makes the parts of a model at the places of its links; only places and materials are new at each tick. */
final class ModelParts {
  private static final Rgba MARKED = Rgba.of(0xff9e3d);
  private static final double AXIS = 0.1;
  private static final float LETTERS = 14;
  private static final TriangleMesh AXES = Scaled.by(Meshes.axes(), new Vector3(AXIS, AXIS, AXIS));

  private final Loaded.Model loaded;
  private final Map<String, Describer> describers = new HashMap<>();
  private final Map<String, Label> labels = new HashMap<>();

  ModelParts(Loaded.Model loaded, Supplier<Map<String, Double>> positions) {
    this.loaded = loaded;
    for (Link link : loaded.model().links()) {
      describers.put(link.name(), new LinkDescriber(loaded, link, positions));
      labels.put(link.name(), new Label(link.name(), LETTERS, PointSet.Unit.PIXELS));
    }
  }

  /** Which part of the display it is over time. */
  private record Key(String link, String what, int index) {}

  List<Part> parts(Map<String, RigidTransform> places, Settings settings, Rgba robotColor) {
    List<Part> parts = new ArrayList<>();
    Set<String> marked = marked(settings.text(RobotModelType.GROUP));
    for (Link link : loaded.model().links()) {
      RigidTransform place = places.get(link.name());
      if (place != null) {
        forms(link, place, settings, new Paint(settings, robotColor, marked.contains(link.name())), parts);
      }
    }
    return parts;
  }

  /** The groups that there are; empty without an SRDF. */
  List<String> groups() {
    return loaded.semantics().map(s -> s.groups().stream().map(SemanticModel.Group::name).toList()).orElse(List.of());
  }

  private Set<String> marked(String group) {
    return loaded.semantics().flatMap(s -> s.group(group)).map(g -> Set.copyOf(g.links())).orElse(Set.of());
  }

  private void forms(Link link, RigidTransform place, Settings settings, Paint paint, List<Part> parts) {
    Describer describer = describers.get(link.name());
    for (Form form : loaded.forms().getOrDefault(link.name(), List.of())) {
      if (shown(form.kind(), settings)) {
        parts.add(new Part(new Key(link.name(), form.kind().name(), form.index()), paint.shape(form),
            place.times(form.linkFromForm()), paint.material(form), describer));
      }
    }
    if (settings.flag(RobotModelType.AXES)) {
      parts.add(
          new Part(new Key(link.name(), RobotModelType.AXES, 0), AXES, place, Material.lit(Rgba.WHITE), describer));
    }
    if (settings.flag(RobotModelType.NAMES)) {
      parts.add(new Part(new Key(link.name(), RobotModelType.NAMES, 0), labels.get(link.name()), place,
          Material.flat(robotOr(paint)).onTop(), describer));
    }
  }

  private static Rgba robotOr(Paint paint) {
    return paint.marked ? MARKED : paint.robotColor;
  }

  private static boolean shown(Form.Kind kind, Settings settings) {
    return settings.flag(switch (kind) {
      case VISUAL, PLACEHOLDER -> RobotModelType.VISUAL;
      case COLLISION -> RobotModelType.COLLISION;
      case INERTIA -> RobotModelType.INERTIA;
    });
  }

  /** How the forms of a link are coloured. */
  private record Paint(double opacity, boolean own, Rgba robotColor, boolean marked) {
    Paint(Settings settings, Rgba robotColor, boolean marked) {
      this(settings.number(RobotModelType.OPACITY), settings.text(RobotModelType.COLOR).equals("own"), robotColor,
          marked);
    }

    private boolean keeps(Form form) {
      return form.kind() != Form.Kind.VISUAL || own && !marked;
    }

    TriangleMesh shape(Form form) {
      return keeps(form) ? form.shape() : form.plain();
    }

    Material material(Form form) {
      Rgba color = keeps(form) ? form.color() : marked ? MARKED : robotColor;
      Rgba seen = color.withAlpha(color.alpha() * opacity);
      return new Material(seen, true, keeps(form) ? form.texture() : Optional.empty(), Material.Depth.TESTED);
    }
  }
}
