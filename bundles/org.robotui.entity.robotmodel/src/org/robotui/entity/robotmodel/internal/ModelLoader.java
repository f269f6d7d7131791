package org.robotui.entity.robotmodel.internal;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.TriangleMesh;
import org.robotui.urdf.Collision;
import org.robotui.urdf.Geometry;
import org.robotui.urdf.Inertial;
import org.robotui.urdf.Kinematics;
import org.robotui.urdf.Link;
import org.robotui.urdf.Parsed;
import org.robotui.urdf.Problem;
import org.robotui.urdf.RobotModel;
import org.robotui.urdf.SemanticModel;
import org.robotui.urdf.Srdf;
import org.robotui.urdf.Surface;
import org.robotui.urdf.Urdf;
import org.robotui.urdf.Visual;
import org.robotui.urdf.pack.PackageFolders;

/** Reads a model with its meshes. Blocks; one load, on one thread. */
final class ModelLoader {
  private static final Rgba UNPAINTED = Rgba.of(0xb4b9c2);
  private static final Rgba TOUCHING = Rgba.of(0xe8a33d).withAlpha(0.6);
  private static final Rgba WEIGHT = Rgba.of(0x8e6cd9).withAlpha(0.6);
  private static final Rgba IN_PLACE = Rgba.of(0xd94f4f).withAlpha(0.35);

  private final LoadRequest request;
  private final List<String> problems = new ArrayList<>();
  private final ModelShapes shapes;

  private ModelLoader(LoadRequest request) {
    this.request = request;
    List<Path> roots = Stream.concat(request.packages().stream(), request.description().packageRoots().stream())
        .flatMap(text -> path(text).stream()).toList();
    this.shapes = new ModelShapes(new MeshCache(new PackageFolders(roots), problems));
  }

  static Loaded load(LoadRequest request) {
    return switch (Urdf.parse(request.description().urdf())) {
      case Parsed.Refused<RobotModel>(Problem problem) -> new Loaded.Broken(
          request.description().name() + ", " + problem);
      case Parsed.Ok<RobotModel>(RobotModel model, List<Problem> warnings) -> new ModelLoader(request).load(model,
          warnings);
    };
  }

  private Loaded load(RobotModel model, List<Problem> warnings) {
    Map<String, List<Form>> forms = new HashMap<>();
    for (Link link : model.links()) {
      if (Thread.currentThread().isInterrupted()) {
        return new Loaded.Broken("the load was ended");
      }
      if (shapes.full()) {
        problems.add("the meshes take more than " + (ModelShapes.MOST_BYTES >> 20)
            + " MB; the rest is left out. Coarser meshes would help");
        break;
      }
      forms.put(link.name(), forms(link));
    }
    // Last: a mesh that is absent matters more than a colour.
    warnings.forEach(warning -> problems.add(request.description().name() + ", " + warning));
    return new Loaded.Model(model, new Kinematics(model), semantics(model), Map.copyOf(forms), List.copyOf(problems));
  }

  private Optional<SemanticModel> semantics(RobotModel model) {
    String text = request.description().srdf();
    if (text.isBlank()) {
      return Optional.empty();
    }
    Parsed<SemanticModel> read = Srdf.parse(text, model);
    if (read instanceof Parsed.Refused<SemanticModel>(Problem problem)) {
      problems.add("SRDF, " + problem);
    }
    return read.found();
  }

  private List<Form> forms(Link link) {
    List<Form> forms = new ArrayList<>();
    boolean whole = true;
    for (Visual visual : link.visuals()) {
      List<Form> found = visual(visual, forms.size());
      forms.addAll(found);
      whole &= !found.isEmpty();
    }
    if (!whole) {
      forms.addAll(touching(link, Form.Kind.PLACEHOLDER, IN_PLACE));
    }
    if (request.collision()) {
      forms.addAll(touching(link, Form.Kind.COLLISION, TOUCHING));
    }
    link.inertial().flatMap(this::weight).ifPresent(forms::add);
    return List.copyOf(forms);
  }

  private List<Form> visual(Visual visual, int index) {
    Rgba painted = visual.surface().flatMap(Surface::color).map(ModelShapes::rgba).orElse(UNPAINTED);
    List<Form> forms = new ArrayList<>();
    for (Skin skin : shapes.skins(visual.geometry(), painted, visual.surface().flatMap(Surface::texture))) {
      forms.add(new Form(Form.Kind.VISUAL, index + forms.size(), visual.linkFromForm(), skin.shape(), skin.plain(),
          skin.own() ? Rgba.WHITE : painted,
          skin.texture()));
    }
    return forms;
  }

  /** Forms that can touch; in place of what is missing only those that need no file. */
  private List<Form> touching(Link link, Form.Kind kind, Rgba color) {
    List<Form> forms = new ArrayList<>();
    for (int i = 0; i < link.collisions().size(); i++) {
      Collision collision = link.collisions().get(i);
      boolean file = collision.geometry() instanceof Geometry.MeshFile;
      Optional<TriangleMesh> shape =
          file && kind == Form.Kind.PLACEHOLDER ? Optional.empty() : shapes.plain(collision.geometry());
      int index = i;
      shape.ifPresent(s -> forms.add(new Form(kind, index, collision.linkFromForm(), s, s, color)));
    }
    return forms;
  }

  /** The box of even density with the mass and the moments about the axes; none where no body has such moments. */
  private Optional<Form> weight(Inertial inertial) {
    Vector3 edges = new Vector3(
        edge(inertial.mass(), inertial.iyy() + inertial.izz() - inertial.ixx()),
        edge(inertial.mass(), inertial.ixx() + inertial.izz() - inertial.iyy()),
        edge(inertial.mass(), inertial.ixx() + inertial.iyy() - inertial.izz()));
    if (!edges.isFinite()) {
      return Optional.empty();
    }
    RigidTransform place = inertial.linkFromCenter();
    return shapes.plain(new Geometry.Box(edges)).map(box -> new Form(Form.Kind.INERTIA, 0, place, box, box, WEIGHT));
  }

  private static double edge(double mass, double moments) {
    return Math.sqrt(6 * moments / mass);
  }

  private static Optional<Path> path(String text) {
    try {
      return text.isBlank() ? Optional.empty() : Optional.of(Path.of(text));
    } catch (InvalidPathException e) {
      // a folder that cannot be has no meshes
      return Optional.empty();
    }
  }
}
