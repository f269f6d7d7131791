package org.robotui.entity.marker.internal;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.data.marker.Color;
import org.robotui.data.marker.Marker;
import org.robotui.entity.marker.internal.MeshShelf.State;
import org.robotui.entity.marker.internal.MeshShelf.Surface;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Placings;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Texture;
import org.robotui.urdf.pack.PackageFolders;

/** Markers that are meshes from files, during one tick. The scaled shapes are kept as long as their markers. */
final class MeshParts {
  private static final Rgba PLAIN = Rgba.of(0xc8ccd2);

  private record Key(Held.Id marker, int surface) {}

  private record Made(Held held, List<Instances> shapes) {}

  private final MeshShelf shelf;
  private final Map<Held.Id, Made> made = new HashMap<>();
  private PackageFolders folders = new PackageFolders(List.of());
  private Optional<List<?>> configured = Optional.empty();
  private String problem = "";
  private int reading;

  MeshParts(MeshShelf shelf) {
    this.shelf = shelf;
  }

  /** Forgets what is gone; with other folders, all is read anew. */
  void begin(List<?> packages, Collection<Held> markers) {
    if (configured.filter(packages::equals).isEmpty()) {
      configured = Optional.of(List.copyOf(packages));
      folders = new PackageFolders(paths(packages));
      clear();
    }
    if (!made.isEmpty()) {
      made.keySet().retainAll(markers.stream().map(Held::id).collect(Collectors.toSet()));
    }
    problem = "";
    reading = 0;
  }

  private static List<Path> paths(List<?> packages) {
    if (packages.isEmpty()) {
      return PackageFolders.split(Optional.ofNullable(System.getenv("ROS_PACKAGE_PATH")).orElse(""));
    }
    List<Path> paths = new ArrayList<>();
    for (Object folder : packages) {
      try {
        paths.add(Path.of(folder.toString()));
      } catch (InvalidPathException e) {
        continue; // what is no path holds no packages; the meshes that are missed are named
      }
    }
    return paths;
  }

  void show(Held held, RigidTransform place, double opacity, List<Part> parts) {
    switch (shelf.of(held.marker().mesh(), folders)) {
      case State.Reading r -> reading++;
      case State.Failed failed -> complain(held, failed.why());
      case State.Ready ready -> {
        if (held.marker().embeddedMaterials()) {
          complain(held, ready.lack());
        }
        show(held, ready.surfaces(), place.times(held.look().mesh().orElseThrow()), opacity, parts);
      }
    }
  }

  private void complain(Held held, String why) {
    problem = problem.isEmpty() && !why.isEmpty() ? "marker " + held.id().key() + ": " + why : problem;
  }

  private void show(Held held, List<Surface> surfaces, RigidTransform at, double opacity, List<Part> parts) {
    Made shapes = made.get(held.id());
    if (shapes == null || shapes.held() != held) {
      shapes = new Made(held, surfaces.stream()
          .map(s -> new Placings(1).add(RigidTransform.IDENTITY, held.marker().scale()).of(s.mesh())).toList());
      made.put(held.id(), shapes);
    }
    for (int i = 0; i < surfaces.size(); i++) {
      Rgba paint = paint(held.marker(), surfaces.get(i));
      Optional<Texture> texture = surfaces.get(i).texture().filter(picture -> held.marker().embeddedMaterials());
      Material material = new Material(paint.withAlpha(paint.alpha() * opacity), true, texture, Material.Depth.TESTED);
      parts.add(new Part(new Key(held.id(), i), shapes.shapes().get(i), at, material, held.describer()));
    }
  }

  /** The marker's colour tints those of the file; one that is all zero says that there is none. */
  private static Rgba paint(Marker marker, Surface surface) {
    Rgba tint = Looks.color(marker);
    if (!marker.embeddedMaterials()) {
      return tint;
    }
    Rgba own = surface.texture().isPresent() ? Rgba.WHITE.withAlpha(surface.color().map(Rgba::alpha).orElse(1f))
        : surface.color().orElse(PLAIN);
    boolean none = marker.color().equals(new Color(0, 0, 0, 0));
    return none ? own
        : new Rgba(own.red() * tint.red(), own.green() * tint.green(), own.blue() * tint.blue(),
            own.alpha() * tint.alpha());
  }

  /** Which mesh cannot be shown, or not as it should be, and why; empty where all can. */
  String problem() {
    return problem;
  }

  /** How many meshes are waited for, as the end of a sentence. */
  String progress() {
    return reading == 0 ? "" : "; " + reading + (reading == 1 ? " mesh is being read" : " meshes are being read");
  }

  void clear() {
    made.clear();
    shelf.clear();
  }
}
