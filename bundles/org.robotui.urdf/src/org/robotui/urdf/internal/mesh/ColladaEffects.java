package org.robotui.urdf.internal.mesh;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.urdf.Color;
import org.robotui.urdf.internal.Refusal;
import org.robotui.urdf.internal.XmlNode;

/** What materials look like: their diffuse colour or picture, and how opaque they are. */
final class ColladaEffects {
  private static final List<String> SHADERS = List.of("phong", "lambert", "blinn", "constant");

  private final Map<String, XmlNode> byId;

  ColladaEffects(Map<String, XmlNode> byId) {
    this.byId = byId;
  }

  Optional<Color> color(XmlNode material) {
    return shader(material).flatMap(this::shaded);
  }

  Optional<String> texture(XmlNode material) {
    return profile(material).flatMap(profile -> shader(material)
        .flatMap(shader -> shader.at("diffuse", "texture")).flatMap(texture -> texture.attribute("texture"))
        .flatMap(name -> image(profile, name)));
  }

  private Optional<XmlNode> profile(XmlNode material) {
    return material.child("instance_effect").flatMap(i -> i.attribute("url")).filter(u -> u.startsWith("#"))
        .map(u -> byId.get(u.substring(1))).flatMap(effect -> effect.child("profile_COMMON"));
  }

  private Optional<XmlNode> shader(XmlNode material) {
    return profile(material).flatMap(profile -> profile.child("technique"))
        .flatMap(technique -> SHADERS.stream().flatMap(name -> technique.child(name).stream()).findFirst());
  }

  private Optional<Color> shaded(XmlNode shader) {
    return numbers(shader.at("diffuse", "color")
        .or(() -> shader.at("emission", "color").filter(c -> shader.name().equals("constant"))))
        .filter(rgba -> rgba.size() >= 3)
        .map(rgba -> new Color(rgba.get(0), rgba.get(1), rgba.get(2), alpha(shader, rgba)));
  }

  /** Exporters disagree whether 0 or 1 is opaque; what would be invisible is taken as opaque. */
  private static float alpha(XmlNode shader, FloatList diffuse) {
    float own = diffuse.size() > 3 ? diffuse.get(3) : 1;
    boolean byAlpha =
        shader.child("transparent").map(t -> t.attribute("opaque").orElse("A_ONE").equals("A_ONE")).orElse(false);
    float factor =
        numbers(shader.at("transparency", "float")).filter(f -> byAlpha && f.size() == 1).map(f -> f.get(0)).orElse(1f);
    float by =
        numbers(shader.at("transparent", "color")).filter(c -> byAlpha && c.size() == 4).map(c -> c.get(3)).orElse(1f);
    float alpha = own * factor * by;
    return alpha > 0.01f && alpha <= 1 ? alpha : 1;
  }

  private Optional<String> image(XmlNode profile, String name) {
    String sampled = parameter(profile, name).flatMap(p -> p.at("sampler2D", "source")).map(XmlNode::text).orElse(name);
    String image =
        parameter(profile, sampled).flatMap(p -> p.at("surface", "init_from")).map(XmlNode::text).orElse(sampled);
    return Optional.ofNullable(byId.get(image)).flatMap(i -> i.child("init_from")).map(XmlNode::text)
        .filter(file -> !file.isEmpty());
  }

  private static Optional<XmlNode> parameter(XmlNode profile, String sid) {
    return profile.children("newparam").stream().filter(p -> p.attribute("sid").filter(sid::equals).isPresent())
        .findFirst();
  }

  private static Optional<FloatList> numbers(Optional<XmlNode> node) {
    try {
      return node.isPresent() ? Optional.of(ColladaNumbers.floats(node.get())) : Optional.empty();
    } catch (Refusal e) {
      // a broken colour is none
      return Optional.empty();
    }
  }
}
