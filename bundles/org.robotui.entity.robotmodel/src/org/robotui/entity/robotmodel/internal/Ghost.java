package org.robotui.entity.robotmodel.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.urdf.Link;

/**
 * Translucent figures of the links that a plan moves. Shapes are those of the model; places of the trail are computed
 * once.
 */
final class Ghost {
  /** The most figures of a trail. */
  static final int MOST_FIGURES = 50;

  private final Course course;
  private final List<Link> links;
  private final Describer describer;
  private List<Map<String, RigidTransform>> trail = List.of();
  private int every;

  Ghost(Course course, Describer describer) {
    this.course = course;
    this.links = course.links();
    this.describer = describer;
  }

  private record Key(int figure, String link, int form) {}

  /** One figure where the joints are at a moment. */
  void figure(RigidTransform fixedFromRoot, Map<String, Double> positions, Material material, List<Part> parts) {
    figure(0, fixedFromRoot, course.places(positions), material, parts);
  }

  /** Figures at each n-th point. */
  void trail(int n, RigidTransform fixedFromRoot, Material material, List<Part> parts) {
    prepare(n);
    for (int i = 0; i < trail.size(); i++) {
      figure(i + 1, fixedFromRoot, trail.get(i), material, parts);
    }
  }

  private void prepare(int n) {
    if (every == n) {
      return;
    }
    every = n;
    int points = course.plan().points();
    int step = Math.max(n, (points + MOST_FIGURES - 1) / MOST_FIGURES);
    trail = new ArrayList<>();
    for (int point = 0; point < points; point += step) {
      trail.add(course.places(course.plan().at(point)));
    }
  }

  private void figure(int number, RigidTransform fixedFromRoot, Map<String, RigidTransform> places, Material material,
      List<Part> parts) {
    for (Link link : links) {
      RigidTransform place = fixedFromRoot.times(places.get(link.name()));
      for (Form form : course.loaded().forms().getOrDefault(link.name(), List.of())) {
        if (form.kind() == Form.Kind.VISUAL || form.kind() == Form.Kind.PLACEHOLDER) {
          parts.add(new Part(new Key(number, link.name(), 2 * form.index() + (form.kind() == Form.Kind.VISUAL ? 0 : 1)),
              form.plain(), place.times(form.linkFromForm()), material, describer));
        }
      }
    }
  }
}
