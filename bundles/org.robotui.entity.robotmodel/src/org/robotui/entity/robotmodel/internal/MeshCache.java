package org.robotui.entity.robotmodel.internal;

import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.urdf.mesh.Mesh;
import org.robotui.urdf.mesh.MeshRead;
import org.robotui.urdf.mesh.MeshReader;
import org.robotui.urdf.pack.PackageFile;
import org.robotui.urdf.pack.PackageFolders;

/** Reads each file once during a load. Used by one thread. */
final class MeshCache {
  private final PackageFolders folders;
  private final List<String> problems;
  private final Map<String, Optional<Mesh>> meshes = new HashMap<>();

  MeshCache(PackageFolders folders, List<String> problems) {
    this.folders = folders;
    this.problems = problems;
  }

  /** The mesh, or none, where the problem is noted once. */
  Optional<Mesh> mesh(String uri) {
    Optional<Mesh> known = meshes.get(uri);
    if (known == null) {
      known = load(uri);
      meshes.put(uri, known);
    }
    return known;
  }

  private Optional<Mesh> load(String uri) {
    return switch (folders.find(uri)) {
      case PackageFile.Refused refused -> refuse(refused.why());
      case PackageFile.Found found -> read(uri, found);
    };
  }

  private Optional<Mesh> read(String uri, PackageFile.Found file) {
    try {
      return switch (MeshReader.read(uri, file.bytes(), name -> beside(file, name))) {
        case MeshRead.Refused refused -> refuse(file.file() + ": " + refused.why());
        case MeshRead.Ok ok -> {
          ok.warnings().forEach(warning -> problems.add(file.file() + ": " + warning));
          yield Optional.of(ok.mesh());
        }
      };
    } catch (IOException e) {
      return refuse(file.file() + " cannot be read: " + e.getMessage());
    }
  }

  private Optional<byte[]> beside(PackageFile.Found file, String name) {
    try {
      Optional<PackageFile.Found> other = folders.beside(file, name).found();
      return other.isPresent() ? Optional.of(other.get().bytes()) : Optional.empty();
    } catch (IOException e) {
      // the reader of the mesh says that it lacks the file
      return Optional.empty();
    }
  }

  private Optional<Mesh> refuse(String why) {
    problems.add(why);
    return Optional.empty();
  }
}
