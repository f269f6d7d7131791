package org.robotui.entity.marker.internal;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.marker.Marker;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Placings;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Rgba;

/**
 * Up to some hundred solids of one form that are drawn at once. Few enough that a marker which changes often has not
 * many others made anew with it, many enough that ten thousand are a handful of parts.
 */
final class Chunk {
  static final int MOST = 512;

  /** Its place among the parts of the display. */
  record Key(long number) {}

  /** A piece of a marker. */
  record Member(Held.Id marker, int piece) {}

  private record Filled(Instances instances, Describer describer) {}

  private final Key key;
  private final Group group;
  private final Map<Member, Held> members = new LinkedHashMap<>();
  private Optional<Filled> filled = Optional.empty();

  Chunk(long number, Group group) {
    this.key = new Key(number);
    this.group = group;
  }

  Key key() {
    return key;
  }

  Group group() {
    return group;
  }

  boolean full() {
    return members.size() >= MOST;
  }

  boolean empty() {
    return members.isEmpty();
  }

  void add(Held held, int piece) {
    members.put(new Member(held.id(), piece), held);
    filled = Optional.empty();
  }

  void remove(Held held) {
    for (int piece = 0; piece < held.look().pieces().size(); piece++) {
      members.remove(new Member(held.id(), piece));
    }
    filled = Optional.empty();
  }

  /** The very same object as long as no member changed. */
  Instances instances() {
    return fill().instances();
  }

  Describer describer() {
    return fill().describer();
  }

  private Filled fill() {
    Filled made = filled.orElseGet(this::made);
    filled = Optional.of(made);
    return made;
  }

  private Filled made() {
    Placings placings = new Placings(members.size());
    List<Marker> markers = new ArrayList<>(members.size());
    members.forEach((member, held) -> {
      MarkerShapes.Piece piece = held.look().pieces().get(member.piece());
      Rgba color = Looks.color(held.marker());
      placings.add(piece.at(), piece.scale(), color);
      markers.add(held.marker());
    });
    return new Filled(placings.of(group.form().mesh()), (element, place) -> described(markers, element));
  }

  private static Properties described(List<Marker> markers, int element) {
    return element >= 0 && element < markers.size() ? MarkerText.of(markers.get(element), element)
        : Properties.of("Marker");
  }
}
