package org.robotui.urdf.internal.mesh;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.robotui.urdf.internal.Refusal;
import org.robotui.urdf.internal.XmlLimits;
import org.robotui.urdf.internal.XmlNode;
import org.robotui.urdf.internal.XmlReader;

/** Reads COLLADA: the geometries of the visual scene, each at its place. */
public final class ColladaReader {
  private static final int DEEPEST = 64;
  private static final int MOST_INSTANCES = 100_000;

  private final MeshBuilder builder;
  private final List<String> warnings;
  private final Map<String, XmlNode> byId = new HashMap<>();
  private int instances;

  /** Takes where triangles and warnings go. */
  public ColladaReader(MeshBuilder builder, List<String> warnings) {
    this.builder = builder;
    this.warnings = warnings;
  }

  /** Adds all that the scene shows. */
  public void read(byte[] bytes) throws Refusal {
    XmlNode root = XmlReader.read(bytes, XmlLimits.MESH);
    if (!root.name().equals("COLLADA")) {
      throw root.refusal("the outermost element is <" + root.name() + ">, must be <COLLADA>");
    }
    index(root);
    double metre =
        root.at("asset", "unit").map(unit -> attribute(unit, "meter")).orElse(OptionalDouble.empty()).orElse(1);
    if (!(metre > 0) || !Double.isFinite(metre)) {
      throw root.refusal("<unit meter=\"" + metre + "\">, must be a positive number");
    }
    Matrix unit = Matrix.scaled(metre, metre, metre);
    Optional<XmlNode> scene = root.at("scene", "instance_visual_scene").flatMap(this::target)
        .or(() -> root.at("library_visual_scenes", "visual_scene"));
    if (scene.isPresent()) {
      for (XmlNode node : scene.get().children("node")) {
        node(node, unit, 0);
      }
    } else {
      for (XmlNode geometry : root.child("library_geometries").map(library -> library.children("geometry"))
          .orElse(List.of())) {
        geometry(geometry, unit, Map.of());
      }
    }
  }

  /** All elements with a name of their own, without going deeper than the reader of XML went. */
  private void index(XmlNode node) {
    node.attribute("id").ifPresent(id -> byId.putIfAbsent(id, node));
    node.children().forEach(this::index);
  }

  private void node(XmlNode node, Matrix parent, int depth) throws Refusal {
    if (depth > DEEPEST || ++instances > MOST_INSTANCES) {
      throw node.refusal("nodes contain themselves, lie more than " + DEEPEST + " deep in each other or are more than "
          + MOST_INSTANCES);
    }
    Matrix at = parent;
    for (XmlNode child : node.children()) {
      switch (child.name()) {
        case "matrix", "translate", "rotate", "scale" -> at = at.times(ColladaNumbers.step(child));
        case "node" -> node(child, at, depth + 1);
        case "instance_node" -> {
          Optional<XmlNode> target = target(child);
          if (target.isPresent()) {
            node(target.get(), at, depth + 1);
          }
        }
        case "instance_geometry" -> instance(target(child), child, at);
        case "instance_controller" -> instance(target(child).flatMap(c -> c.child("skin")).flatMap(this::source), child,
            at);
        default -> {}
      }
    }
  }

  private void instance(Optional<XmlNode> geometry, XmlNode instance, Matrix at) throws Refusal {
    if (geometry.isEmpty()) {
      warnings.add("line " + instance.line() + ": names a geometry that is not in the file");
      return;
    }
    if (++instances > MOST_INSTANCES) {
      throw instance.refusal("more than " + MOST_INSTANCES + " geometries");
    }
    Map<String, XmlNode> materials = new HashMap<>();
    for (XmlNode bound : instance.at("bind_material", "technique_common").map(t -> t.children("instance_material"))
        .orElse(List.of())) {
      reference(bound.attribute("target")).ifPresent(m -> materials.put(bound.attribute("symbol").orElse(""), m));
    }
    geometry(geometry.get(), at, materials);
  }

  private void geometry(XmlNode geometry, Matrix at, Map<String, XmlNode> materials) throws Refusal {
    Optional<XmlNode> mesh = geometry.child("mesh");
    if (mesh.isEmpty()) {
      warnings.add("line " + geometry.line() + ": a geometry without a <mesh> is not shown");
      return;
    }
    ColladaEffects effects = new ColladaEffects(byId);
    for (XmlNode primitive : mesh.get().children()) {
      switch (primitive.name()) {
        case "triangles", "polylist", "polygons", "trifans", "tristrips" -> {
          new ColladaPrimitives(builder, byId, at).read(primitive);
          Optional<XmlNode> material =
              primitive.attribute("material").flatMap(symbol -> Optional.ofNullable(materials.get(symbol))
                  .or(() -> Optional.ofNullable(byId.get(symbol))));
          builder.part(material.flatMap(effects::color), material.flatMap(effects::texture));
        }
        default -> {}
      }
    }
  }

  private Optional<XmlNode> target(XmlNode instance) {
    return reference(instance.attribute("url"));
  }

  private Optional<XmlNode> source(XmlNode skin) {
    return reference(skin.attribute("source"));
  }

  private Optional<XmlNode> reference(Optional<String> url) {
    return url.filter(u -> u.startsWith("#")).map(u -> byId.get(u.substring(1)));
  }

  private static OptionalDouble attribute(XmlNode node, String name) {
    try {
      return node.attribute(name).map(Double::parseDouble).map(OptionalDouble::of).orElse(OptionalDouble.empty());
    } catch (NumberFormatException e) {
      return OptionalDouble.of(Double.NaN);
    }
  }
}
