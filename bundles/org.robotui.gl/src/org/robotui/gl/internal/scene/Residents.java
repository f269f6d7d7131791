package org.robotui.gl.internal.scene;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Texture;

/**
 * What of a scene is on the graphics card: for each part one {@link Resident}, made, refilled and freed as requests
 * say.
 */
final class Residents {
  /** One part may not take more: indices and buffers of Java end there. */
  static final long MOST_BYTES = 1L << 30;

  private static final int KIB = 1024;

  private record Place(Object display, Object key) {}

  private final Gpu gpu;
  private final Pool pool;
  private final long most;
  private Map<Place, Resident> residents = new HashMap<>();

  Residents(Gpu gpu, long most) {
    this.gpu = gpu;
    this.most = most;
    pool = new Pool(gpu);
  }

  /** Makes it so that these parts and no others are there; answers what is wrong with some. */
  List<String> follow(Map<Object, List<Part>> wanted) {
    List<String> problems = new ArrayList<>();
    Map<Place, Resident> before = residents;
    residents = HashMap.newHashMap(before.size());
    wanted.forEach(
        (display, parts) -> parts.forEach(part -> follow(before, new Place(display, part.key()), part, problems)));
    before.values().forEach(Resident::release);
    return problems;
  }

  private void follow(Map<Place, Resident> before, Place place, Part part, List<String> problems) {
    if (tooMuch(part, problems)) {
      return;
    }
    if (residents.containsKey(place)) {
      problems.add("The part " + part.key() + " is there twice.");
      return;
    }
    Resident present = before.remove(place);
    if (present == null) {
      residents.put(place, new Resident(pool, place.display(), part));
    } else {
      present.update(part);
      residents.put(place, present);
    }
  }

  private boolean tooMuch(Part part, List<String> problems) {
    if (part.shape().bytes() > most) {
      problems.add("The part " + part.key() + " takes " + part.shape().bytes() / KIB + " KiB; one part may take "
          + most / KIB + " KiB.");
      return true;
    }
    return part.material().texture().map(texture -> tooMuch(part, texture, problems)).orElse(false);
  }

  private boolean tooMuch(Part part, Texture texture, List<String> problems) {
    int edge = gpu.limits().texture();
    if (texture.width() <= edge && texture.height() <= edge) {
      return false;
    }
    problems.add("The texture of " + part.key() + " has " + texture.width() + " x " + texture.height()
        + " pixels; this graphics takes "
        + edge + " along an edge.");
    return true;
  }

  Collection<Resident> all() {
    return residents.values();
  }

  long takeSent() {
    return pool.takeSent();
  }

  long bytes() {
    return pool.bytes();
  }

  void delete() {
    pool.delete();
    residents.clear();
  }
}
