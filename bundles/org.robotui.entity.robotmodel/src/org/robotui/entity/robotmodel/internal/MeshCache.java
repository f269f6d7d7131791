package org.robotui.entity.robotmodel.internal;

import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.gl.shape.Texture;
import org.robotui.urdf.mesh.MeshRead;
import org.robotui.urdf.mesh.MeshReader;
import org.robotui.urdf.mesh.Picture;
import org.robotui.urdf.mesh.PictureRead;
import org.robotui.urdf.mesh.PictureReader;
import org.robotui.urdf.pack.PackageFile;
import org.robotui.urdf.pack.PackageFolders;

/** Reads each file once during a load. Used by one thread. */
final class MeshCache {
  private final PackageFolders folders;
  private final List<String> problems;
  private final Map<String, Optional<MeshFile>> meshes = new HashMap<>();
  private final Map<String, Optional<Texture>> textures = new HashMap<>();

  MeshCache(PackageFolders folders, List<String> problems) {
    this.folders = folders;
    this.problems = problems;
  }

  /** The mesh, or none, where the problem is noted once. */
  Optional<MeshFile> mesh(String uri) {
    Optional<MeshFile> known = meshes.get(uri);
    if (known == null) {
      known = load(uri);
      meshes.put(uri, known);
    }
    return known;
  }

  /** The picture of a material of the model, or none, where the problem is noted once. */
  Optional<Texture> texture(String uri) {
    Optional<Texture> known = textures.get(uri);
    if (known == null) {
      known = picture(uri).map(MeshCache::texture);
      textures.put(uri, known);
    }
    return known;
  }

  private Optional<Picture> picture(String uri) {
    return switch (folders.find(uri)) {
      case PackageFile.Refused refused -> noPicture(refused.why());
      case PackageFile.Found found -> picture(found);
    };
  }

  private Optional<Picture> picture(PackageFile.Found found) {
    try {
      return switch (PictureReader.read(found.bytes())) {
        case PictureRead.Refused refused -> noPicture(found.file() + ": " + refused.why());
        case PictureRead.Ok ok -> Optional.of(ok.picture());
      };
    } catch (IOException e) {
      return noPicture(found.file() + " cannot be read: " + e.getMessage());
    }
  }

  private Optional<Picture> noPicture(String why) {
    problems.add("the texture of a material is not shown: " + why);
    return Optional.empty();
  }

  private static Map<String, Texture> textures(Map<String, Picture> pictures) {
    Map<String, Texture> textures = new HashMap<>();
    pictures.forEach((name, picture) -> textures.put(name, texture(picture)));
    return textures;
  }

  private static Texture texture(Picture picture) {
    return new Texture(picture.width(), picture.height(), picture.rgba(), true, true);
  }

  private Optional<MeshFile> load(String uri) {
    return switch (folders.find(uri)) {
      case PackageFile.Refused refused -> refuse(refused.why());
      case PackageFile.Found found -> read(uri, found);
    };
  }

  private Optional<MeshFile> read(String uri, PackageFile.Found file) {
    try {
      return switch (MeshReader.read(uri, file.bytes(), name -> beside(file, name))) {
        case MeshRead.Refused refused -> refuse(file.file() + ": " + refused.why());
        case MeshRead.Ok ok -> {
          ok.warnings().forEach(warning -> problems.add(file.file() + ": " + warning));
          yield Optional.of(new MeshFile(ok.mesh(), textures(ok.pictures())));
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

  private Optional<MeshFile> refuse(String why) {
    problems.add(why);
    return Optional.empty();
  }
}
