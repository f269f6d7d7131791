package org.robotui.rfic.roblets.internal.call;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.message.roblets.ElementRecord;
import org.robotui.rfic.roblets.internal.feed.BodyFeeds;
import org.robotui.roblets.tree.BodyForm;
import org.robotui.roblets.wire.RobletStatus;

/** What a brain knows: roblets as nodes, what they say as topics, and what they take as services. */
public final class RobletsBrowser implements Browser {
  private static final String BRAIN = "brain";

  private final BodyFeeds feeds;

  public RobletsBrowser(BodyFeeds feeds) {
    this.feeds = feeds;
  }

  @Override
  public List<Item> list(Kind kind) {
    List<Item> all = new ArrayList<>();
    for (RobletStatus status : feeds.statuses()) {
      switch (kind) {
        case NODE -> all.add(new Item(kind, status.form().name(), status.state()));
        case TOPIC -> status.form().outputs().forEach(form -> all.add(item(kind, status, form)));
        case SERVICE -> status.form().inputs().forEach(form -> all.add(item(kind, status, form)));
        case PARAMETER, ACTION, TUNABLE -> {
          // roblets have no such thing
        }
      }
    }
    return all.stream().sorted((a, b) -> a.name().compareTo(b.name())).toList();
  }

  private static Item item(Kind kind, RobletStatus status, BodyForm form) {
    return new Item(kind, status.form().name() + "/" + form.name(), form.as());
  }

  @Override
  public Description describe(Item item) throws CallException {
    String roblet = item.name().split("/", 2)[0];
    RobletStatus status = feeds.status(roblet)
        .orElseThrow(() -> new CallException("the brain does not know the roblet " + roblet + " (any more)"));
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("state", status.state() + (status.reason().isEmpty() ? "" : ": " + status.reason()));
    facts.put("address", status.address());
    facts.put("frequency", status.form().frequency() + " Hz");
    facts.put("restarts", String.valueOf(status.restarts()));
    facts.put("datagrams", status.tally().received() + " received, " + status.tally().lost() + " lost, "
        + status.tally().late() + " late, " + status.tally().doubled() + " doubled");
    if (!status.form().friends().isEmpty()) {
      facts.put("friends", String.join(", ", status.form().friends()));
    }
    Optional<BodyForm> form = form(item, status);
    boolean asked = item.kind() == Kind.SERVICE;
    return new Description(item, facts, form.map(RobletsBrowser::text),
        form.filter(f -> asked).map(f -> ElementRecord.shape(item.name(), f)), Optional.empty());
  }

  private static Optional<BodyForm> form(Item item, RobletStatus status) {
    String message = item.name().substring(item.name().indexOf('/') + 1);
    return switch (item.kind()) {
      case TOPIC -> status.form().output(message);
      case SERVICE -> status.form().input(message);
      default -> Optional.empty();
    };
  }

  private static String text(BodyForm form) {
    StringBuilder text = new StringBuilder("# an element <" + form.name() + "/>\n");
    form.fields().forEach(field -> text.append(field.kind()).append(' ').append(field.name())
        .append(field.unit().isEmpty() ? "" : "  # " + field.unit()).append('\n'));
    return text.toString();
  }

  @Override
  public List<Link> links() {
    List<Link> all = new ArrayList<>();
    for (RobletStatus status : feeds.statuses()) {
      String name = status.form().name();
      status.form().outputs().forEach(form -> add(all, name, name + "/" + form.name(), BRAIN));
      status.form().inputs().forEach(form -> add(all, BRAIN, name + "/" + form.name(), name));
      status.form().friends().forEach(friend -> add(all, name, name + " to " + friend, friend));
    }
    return all;
  }

  private static void add(List<Link> all, String from, String topic, String to) {
    all.add(new Link(from, topic, true));
    all.add(new Link(to, topic, false));
  }

  @Override
  public Optional<Object> parameter(String name) {
    return Optional.empty();
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    throw new CallException("roblets have no parameters; say a message to the one that has " + name);
  }

  @Override
  public List<Tunable> tunables(Item item) throws CallException {
    throw new CallException(item.name() + " has no settings");
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    throw new CallException(item.name() + " has no settings");
  }
}
