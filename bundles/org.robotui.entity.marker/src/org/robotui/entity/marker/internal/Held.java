package org.robotui.entity.marker.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.LongToDoubleFunction;
import org.robotui.api.port.SourceId;
import org.robotui.data.marker.Marker;
import org.robotui.gl.shape.Describer;

/** A marker that is shown. Its shape is made once and kept until it becomes another. */
final class Held {
  /**
   * Names a marker among those of all sources.
   *
   * @param source who sent it
   * @param key its name there
   */
  record Id(SourceId source, Marker.Key key) {}

  private final Id id;
  private final MarkerShapes look;
  private final List<Chunk> chunks = new ArrayList<>();
  private Marker marker;
  private Optional<Spot> spot = Optional.empty();
  private Describer describer;

  Held(Id id, Marker marker) {
    this.id = id;
    this.look = Looks.of(marker);
    renew(marker);
  }

  Id id() {
    return id;
  }

  Marker marker() {
    return marker;
  }

  MarkerShapes look() {
    return look;
  }

  Describer describer() {
    return describer;
  }

  List<Chunk> chunks() {
    return chunks;
  }

  /** Where it is drawn; empty until that is known. */
  Optional<Spot> spot() {
    return spot;
  }

  void at(Optional<Spot> place) {
    spot = place;
  }

  /** Takes one that looks the same: only its lifetime begins anew. */
  void renew(Marker same) {
    marker = same;
    describer = (element, place) -> MarkerText.of(same, element);
  }

  /** Whether its lifetime is over. */
  boolean over(LongToDoubleFunction ages) {
    return marker.lifetimeNanos() > 0 && ages.applyAsDouble(marker.receivedNanos()) > marker.lifetimeNanos() * 1e-9;
  }

  /** Whether another is drawn by the very same shape. */
  boolean looksLike(Marker other) {
    Marker m = marker;
    return m.type() == other.type() && m.pose().equals(other.pose()) && m.scale().equals(other.scale())
        && m.color().equals(other.color())
        && m.points().equals(other.points()) && m.colors().equals(other.colors()) && m.text().equals(other.text())
        && m.mesh().equals(other.mesh()) && m.embeddedMaterials() == other.embeddedMaterials();
  }
}
