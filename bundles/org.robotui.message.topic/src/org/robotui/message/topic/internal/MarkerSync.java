package org.robotui.message.topic.internal;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.data.Keyed;
import org.robotui.data.marker.InteractiveMarker;
import org.robotui.data.marker.InteractiveMarkerSet.Entry;
import org.robotui.message.data.FrameNames;
import org.robotui.message.data.InteractiveMarkers;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerInit;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerPose;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerUpdate;

/**
 * The markers of one server, kept equal to what it has. Updates are numbered: where one is missing, the markers are
 * taken anew from the server's list of all, as soon as an update or a sign of life shows that no change lies between
 * the two. Not safe for several threads.
 */
final class MarkerSync {
  private static final int MOST_WAITING = 100;

  private final String feedback;
  private final Consumer<String> complaints;
  private final Map<String, InteractiveMarker> markers = new LinkedHashMap<>();
  private final Deque<InteractiveMarkerUpdate> waiting = new ArrayDeque<>();
  private Optional<InteractiveMarkerInit> newest = Optional.empty();
  private boolean synchronised;
  private long last;

  MarkerSync(String feedback, Consumer<String> complaints) {
    this.feedback = feedback;
    this.complaints = complaints;
  }

  boolean synchronised() {
    return synchronised;
  }

  /** Takes the list of all markers; answers what changed with it. */
  List<Entry> take(InteractiveMarkerInit init, FrameNames names) {
    newest = Optional.of(init);
    return synchronised ? List.of() : begin(names);
  }

  /** Takes the list of all markers as a server answered it, which counts at once; answers what changed with it. */
  List<Entry> answered(InteractiveMarkerInit init, FrameNames names) {
    newest = Optional.of(init);
    return synchronised ? List.of() : restart(init, names);
  }

  /** Takes an update or a sign of life; answers what changed with it. */
  List<Entry> take(InteractiveMarkerUpdate update, FrameNames names) {
    boolean changes = update.type() == InteractiveMarkerUpdate.UPDATE;
    if (synchronised && update.seqNum() == (changes ? last + 1 : last)) {
      last = update.seqNum();
      return changes ? apply(update, names) : List.of();
    }
    if (synchronised) {
      complaints
          .accept("update " + (last + 1) + " did not come, but " + update.seqNum() + "; all markers are taken anew");
      synchronised = false;
    }
    if (waiting.size() >= MOST_WAITING) {
      waiting.removeFirst();
    }
    waiting.add(update);
    return begin(names);
  }

  /** Begins with the list of all, if what came besides is known to follow it without a gap. */
  private List<Entry> begin(FrameNames names) {
    if (newest.isEmpty() || waiting.stream().noneMatch(u -> follows(u, newest.get().seqNum()))) {
      return List.of();
    }
    return restart(newest.get(), names);
  }

  private List<Entry> restart(InteractiveMarkerInit all, FrameNames names) {
    Map<String, Entry> changed = new LinkedHashMap<>();
    markers.keySet().forEach(name -> changed.put(name, new Entry(name, Optional.empty())));
    markers.clear();
    last = all.seqNum();
    synchronised = true;
    all.markers().forEach(m -> add(m, names).ifPresent(e -> changed.put(e.name(), e)));
    List<InteractiveMarkerUpdate> later = waiting.stream().filter(u -> u.seqNum() > last).toList();
    waiting.clear();
    later.forEach(u -> take(u, names).forEach(e -> changed.put(e.name(), e)));
    return List.copyOf(changed.values());
  }

  private static boolean follows(InteractiveMarkerUpdate update, long number) {
    boolean next = update.type() == InteractiveMarkerUpdate.UPDATE && update.seqNum() == number + 1;
    return next || update.seqNum() == number;
  }

  private List<Entry> apply(InteractiveMarkerUpdate update, FrameNames names) {
    List<Entry> changed = new ArrayList<>();
    update.markers().forEach(m -> add(m, names).ifPresent(changed::add));
    update.poses().forEach(p -> move(p, names).ifPresent(changed::add));
    for (String name : update.erases()) {
      markers.remove(name);
      changed.add(new Entry(name, Optional.empty()));
    }
    return changed;
  }

  private Optional<Entry> add(org.robotui.message.ros.visualization_msgs.InteractiveMarker m, FrameNames names) {
    if (markers.size() >= Keyed.MOST_KEYS && !markers.containsKey(m.name())) {
      complaints.accept("more than " + Keyed.MOST_KEYS + " interactive markers; " + m.name() + " is left out");
      return Optional.empty();
    }
    try {
      InteractiveMarker marker = InteractiveMarkers.marker(m, feedback, names);
      markers.put(marker.name(), marker);
      return Optional.of(new Entry(marker.name(), Optional.of(marker)));
    } catch (IllegalArgumentException e) {
      complaints.accept(e.getMessage());
      return Optional.empty();
    }
  }

  private Optional<Entry> move(InteractiveMarkerPose pose, FrameNames names) {
    return Optional
        .ofNullable(
            markers.computeIfPresent(pose.name(), (name, marker) -> InteractiveMarkers.moved(marker, pose, names)))
        .map(marker -> new Entry(marker.name(), Optional.of(marker)));
  }
}
