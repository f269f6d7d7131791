package org.robotui.entity.marker.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.data.marker.MarkerSet;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Recent;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Rgba;

/** The markers of some sources. Simple solids are drawn together, all others one by one. */
final class MarkersDisplay implements Display {
  private static final int MOST_NAMED = 6;

  private final MarkerStore store = new MarkerStore();
  private final MeshParts meshes;

  MarkersDisplay(DisplayContext context) {
    this.meshes = new MeshParts(new MeshShelf(context));
  }

  @Override
  public DisplayResult update(DisplayTick tick) {
    if (tick.reset() || tick.state() instanceof InputState.Unconnected) {
      close();
    }
    for (Envelope<? extends Data> envelope : tick.arrived()) {
      if (envelope.value() instanceof MarkerSet set) {
        store.take(envelope.source(), set);
      }
    }
    Spots spots = new Spots(tick.places());
    store.tick(spots, tick.places().fixed(), tick.ages());
    meshes.begin(tick.settings().list(MarkersType.PACKAGES), store.markers());
    List<Part> parts = parts(spots, tick.settings(), Recent.opacity(tick));
    return new DisplayResult(parts, status(tick, spots.missing()), store.dropped());
  }

  private List<Part> parts(Spots spots, Settings settings, float fresh) {
    Visible visible = new Visible(settings);
    double opacity = settings.number(MarkersType.OPACITY) * fresh;
    List<Part> parts = new ArrayList<>();
    for (Chunk chunk : store.chunks().all()) {
      Optional<RigidTransform> at =
          visible.shows(chunk.group().namespace()) ? spots.at(chunk.group().spot()) : Optional.empty();
      at.ifPresent(place -> parts.add(new Part(chunk.key(), chunk.instances(), place,
          Material.lit(Rgba.WHITE.withAlpha(opacity)), chunk.describer())));
    }
    for (Held held : store.markers()) {
      if (held.look().own().isPresent() && visible.shows(held.id().key().namespace())) {
        MarkerShapes.Own own = held.look().own().get();
        held.spot().flatMap(spots::at).ifPresent(place -> parts.add(part(held, own, place, opacity)));
      }
      if (held.look().mesh().isPresent() && visible.shows(held.id().key().namespace())) {
        held.spot().flatMap(spots::at).ifPresent(place -> meshes.show(held, place, opacity, parts));
      }
    }
    return parts;
  }

  private static Part part(Held held, MarkerShapes.Own own, RigidTransform place, double opacity) {
    Material m = own.material();
    Material paint = opacity >= 1 ? m
        : new Material(m.color().withAlpha(m.color().alpha() * opacity), m.lit(), m.texture(), m.depth());
    return new Part(held.id(), own.shape(), place.times(own.at()), paint, held.describer());
  }

  private DisplayStatus status(DisplayTick tick, Optional<String> missing) {
    if (store.markers().isEmpty()) {
      boolean live = tick.state() instanceof InputState.Live;
      return new DisplayStatus.NoData(
          live ? "no markers now: none came, or all were taken away" : tick.state().explanation());
    }
    if (missing.isPresent()) {
      return new DisplayStatus.NoFrame(missing.get());
    }
    if (store.dropped() > 0) {
      return new DisplayStatus.Partly("there are more than " + MarkerStore.MOST + " markers; the others are left out");
    }
    String wrong = store.flaws().isEmpty() ? meshes.problem() : store.flaws();
    return wrong.isEmpty() ? new DisplayStatus.Shown(summary(tick.settings()) + meshes.progress())
        : new DisplayStatus.Partly(wrong);
  }

  private String summary(Settings settings) {
    Visible visible = new Visible(settings);
    Map<String, Integer> counts = store.counts();
    String named = counts.entrySet().stream().limit(MOST_NAMED)
        .map(e -> (e.getKey().isEmpty() ? "unnamed" : e.getKey()) + " " + e.getValue()
            + (visible.shows(e.getKey()) ? "" : " (hidden)"))
        .collect(Collectors.joining(", "));
    String more = counts.size() > MOST_NAMED ? " and " + (counts.size() - MOST_NAMED) + " more namespaces" : "";
    int all = store.markers().size();
    return all + (all == 1 ? " marker: " : " markers: ") + named + more;
  }

  /** Which namespaces are shown. */
  private record Visible(List<?> shown, List<?> hidden) {
    Visible(Settings settings) {
      this(settings.list(MarkersType.NAMESPACES), settings.list(MarkersType.HIDDEN));
    }

    boolean shows(String namespace) {
      return (shown.isEmpty() || shown.contains(namespace)) && !hidden.contains(namespace);
    }
  }

  @Override
  public void close() {
    store.clear();
    meshes.clear();
  }
}
