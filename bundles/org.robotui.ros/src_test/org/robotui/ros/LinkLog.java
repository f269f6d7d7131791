package org.robotui.ros;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/** Remembers what happened to links. */
public final class LinkLog implements LinkListener {

  private final List<LinkEvent> events = new CopyOnWriteArrayList<>();

  @Override
  public void onLink(LinkEvent event) {
    events.add(event);
  }

  /** All reasons of failed and closed links of a kind. */
  public List<String> reasons(LinkEvent.Kind kind) {
    return events.stream().filter(event -> event.kind() == kind).map(event -> switch (event.state()) {
      case LinkState.Failed failed -> failed.reason();
      case LinkState.Closed closed -> closed.reason();
      default -> "";
    }).filter(reason -> !reason.isEmpty()).toList();
  }

  /** Waits until a link of a kind failed or closed with a reason that holds all these words. */
  public void awaitReason(LinkEvent.Kind kind, String... words) {
    Eventually.await(kind + " with a reason naming " + List.of(words) + " among " + reasons(kind),
        () -> reasons(kind).stream().anyMatch(reason -> List.of(words).stream().allMatch(reason::contains)));
  }

  /** How often links of a kind got connected. */
  public long connected(LinkEvent.Kind kind) {
    return events.stream().filter(e -> e.kind() == kind && e.state() instanceof LinkState.Connected).count();
  }

  /** All events so far. */
  public List<LinkEvent> events() {
    return events;
  }
}
