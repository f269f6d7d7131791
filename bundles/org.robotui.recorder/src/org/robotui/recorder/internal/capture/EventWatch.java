package org.robotui.recorder.internal.capture;

import java.time.Instant;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.api.alert.AlertEvent;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Principal;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.Host;
import org.robotui.api.host.HostListener;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.recording.RecordedSchema;

/**
 * Says what happened to robots by RobotUI, or as seen by it: who has control, stops, links, alerts, exchanges. The
 * first look says how all is. For the thread of its collector; {@link #say} is for any.
 */
public final class EventWatch implements HostListener {
  /** Where events lie in a recording. */
  public static final String TOPIC = "/robotui/events";

  private static final long LOOK_NANOS = 100_000_000L;

  private final Host host;
  private final NamePatterns robots;
  private final WallTime time;
  private final Consumer<Captured> sink;
  private final StreamHead head = new StreamHead("", TOPIC, DataJson.ENCODING, schema(), Map.of());
  private final Map<String, String> told = new HashMap<>();
  private final Map<String, Instant> alerts = new HashMap<>();
  private long due = System.nanoTime();

  EventWatch(Host host, NamePatterns robots, WallTime time, Consumer<Captured> sink) {
    this.host = host;
    this.robots = robots;
    this.time = time;
    this.sink = sink;
  }

  private static RecordedSchema schema() {
    Map<String, Object> properties = new LinkedHashMap<>();
    List.of("event", "ui", "subject", "value", "text").forEach(name -> properties.put(name, Map.of("type", "string")));
    return DataJson.schema("robotui.Event", properties);
  }

  StreamHead head() {
    return head;
  }

  /** Looks for what is new, where it is time for that. */
  void look() {
    if (System.nanoTime() - due >= 0) {
      lookNow();
    }
  }

  /** Looks for what is new. */
  void lookNow() {
    due = System.nanoTime() + LOOK_NANOS;
    host.ruics().stream().filter(this::isMeant).forEach(this::look);
  }

  private boolean isMeant(Ruic ruic) {
    return robots.mean(ruic.name()) || ruic.authorities().stream().anyMatch(each -> robots.mean(each.robot()));
  }

  private void look(Ruic ruic) {
    String ui = ruic.name();
    RuicSnapshot now = ruic.snapshot();
    changed("state", ui, "", word(now.state()), now.reason());
    for (ComponentStatus part : now.components()) {
      if (part.kind() == ComponentStatus.Kind.RFIC) {
        changed("interface", ui, part.id(), part.type(), "");
        part.link().ifPresent(link -> changed("link", ui, part.id(), link.word().startsWith("retry") ? "failed"
            : link.word(), link.reason()));
      }
    }
    for (Authority each : ruic.authorities()) {
      changed("control", ui, each.robot(), who(each.holder()), "");
      changed("stop", ui, each.robot(), who(each.stoppedBy()), "");
    }
    alerts(ui, ruic.alerts().history());
  }

  private static String who(Optional<Principal> principal) {
    return principal.map(Principal::label).orElse("");
  }

  private static String word(Enum<?> constant) {
    return constant.name().toLowerCase(Locale.ROOT);
  }

  private void alerts(String ui, List<AlertEvent> history) {
    Instant before = alerts.getOrDefault(ui, Instant.ofEpochSecond(0, time.startTime()));
    history.stream().filter(each -> each.time().isAfter(before)).sorted(Comparator.comparing(AlertEvent::time))
        .forEach(each -> {
          alerts.put(ui, each.time());
          say("alert", ui, each.id().name(), word(each.kind()), each.source() + ": " + each.value());
        });
  }

  private void changed(String event, String ui, String subject, String value, String text) {
    String key = event + "\n" + ui + "\n" + subject;
    String now = value + "\n" + text;
    if (!now.equals(told.put(key, now))) {
      say(event, ui, subject, value, text);
    }
  }

  @Override
  public void alert(String ruic, String message) {
    if (ruic.isEmpty() || robots.mean(ruic)) {
      say("fault", ruic, "", "", message);
    }
  }

  /** Something happened. */
  public void say(String event, String ui, String subject, String value, String text) {
    Map<String, Object> members = new LinkedHashMap<>();
    members.put("event", event);
    members.put("ui", ui);
    members.put("subject", subject);
    members.put("value", value);
    members.put("text", text);
    long now = time.now();
    sink.accept(new Captured(head, now, now, 0, DataJson.bytes(members), Optional.empty()));
  }
}
