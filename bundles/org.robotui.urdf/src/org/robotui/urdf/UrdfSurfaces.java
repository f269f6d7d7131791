package org.robotui.urdf;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.urdf.internal.Numbers;
import org.robotui.urdf.internal.Refusal;
import org.robotui.urdf.internal.XmlNode;

/**
 * Materials as RViz takes them: one of the robot goes before one of a visual with the same name, and a name is known
 * everywhere once a visual defined it. A name that nobody defines is a warning, as such models are common.
 */
final class UrdfSurfaces {
  private final List<Problem> warnings;
  private final Map<String, Surface> byName = new HashMap<>();
  private final List<XmlNode> undefined = new ArrayList<>();

  UrdfSurfaces(List<Problem> warnings) {
    this.warnings = warnings;
  }

  void global(List<XmlNode> materials) throws Refusal {
    for (XmlNode node : materials) {
      byName.put(node.required("name"), read(node));
    }
  }

  /** Reads a visual's own. */
  Surface local(XmlNode node) throws Refusal {
    Surface surface = read(node);
    boolean defines = surface.color().isPresent() || surface.texture().isPresent();
    if (defines && !surface.name().isEmpty()) {
      byName.putIfAbsent(surface.name(), surface);
    } else if (!defines) {
      undefined.add(node);
    }
    return surface;
  }

  /** Says which names nobody defined. */
  void resolveLate() {
    for (XmlNode node : undefined) {
      String name = node.attribute("name").orElse("");
      if (!byName.containsKey(name)) {
        warnings.add(new Problem(node.line(), "the material '" + name
            + "' is defined nowhere; write <color rgba=\"...\"/> in it, or define it under <robot>"));
      }
    }
  }

  /** The links with materials in place of their names. */
  List<Link> applied(List<Link> links) {
    return links.stream().map(link -> new Link(link.name(), link.inertial(),
        link.visuals().stream().map(this::applied).toList(), link.collisions())).toList();
  }

  private Visual applied(Visual visual) {
    Optional<Surface> surface = visual.surface().map(s -> byName.getOrDefault(s.name(), s))
        .filter(s -> s.color().isPresent() || s.texture().isPresent());
    return new Visual(visual.name(), visual.linkFromForm(), visual.geometry(), surface);
  }

  private static Surface read(XmlNode node) throws Refusal {
    Optional<XmlNode> color = node.child("color");
    Optional<XmlNode> texture = node.child("texture");
    return new Surface(
        node.attribute("name").orElse(""),
        color.isPresent() ? Optional.of(color(color.get())) : Optional.empty(),
        texture.isPresent() ? Optional.of(texture.get().required("filename")) : Optional.empty());
  }

  private static Color color(XmlNode node) throws Refusal {
    double[] rgba = Numbers.of(node, "rgba", 4);
    return new Color((float) rgba[0], (float) rgba[1], (float) rgba[2], (float) rgba[3]);
  }
}
