package org.robotui.rfic.recording.internal.session;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.message.payload.PayloadFormat;

/** What was recorded. */
final class RecordingBrowser implements Browser {
  private static final String ONLY_TOPICS = "a recording has topics, and nothing else";

  private final TopicTable table;
  private final double seconds;

  /**
   * Creates a browser.
   *
   * @param seconds how long the recording is
   */
  RecordingBrowser(TopicTable table, double seconds) {
    this.table = table;
    this.seconds = seconds;
  }

  @Override
  public List<Item> list(Kind kind) {
    return kind != Kind.TOPIC ? List.of()
        : table.topics().stream().map(topic -> new Item(kind, topic, format(topic).type())).toList();
  }

  private PayloadFormat format(String topic) {
    return table.first(topic).orElseThrow().format();
  }

  @Override
  public Description describe(Item item) throws CallException {
    List<PlayedChannel> channels = table.of(item.name());
    if (item.kind() != Kind.TOPIC || channels.isEmpty()) {
      throw new CallException("the recording has no such thing as " + item.name());
    }
    PlayedChannel first = channels.getFirst();
    long count = channels.stream().mapToLong(PlayedChannel::count).sum();
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("type", item.type());
    facts.put("messages", Long.toString(count));
    facts.put("a second", seconds > 0 ? RecordingWords.number(count / seconds) : "not known");
    facts.put("encoding", first.channel().messageEncoding());
    facts.put("channels", Integer.toString(channels.size()));
    facts.put("latched", first.channel().isLatched() ? "yes" : "no");
    channels.stream().flatMap(each -> each.format().obstacle().stream()).findFirst()
        .ifPresent(reason -> facts.put("definition", reason));
    first.channel().metadata().forEach(facts::putIfAbsent);
    return new Description(item, facts, first.definition(), first.format().shape(), Optional.empty());
  }

  @Override
  public Optional<Object> parameter(String name) throws CallException {
    throw new CallException(ONLY_TOPICS);
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    throw new CallException(ONLY_TOPICS);
  }

  @Override
  public List<Tunable> tunables(Item item) throws CallException {
    throw new CallException(ONLY_TOPICS);
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    throw new CallException(ONLY_TOPICS);
  }

  @Override
  public List<Link> links() {
    return table.all().filter(each -> each.channel().metadata().containsKey(PlayedChannel.SENDER))
        .map(each -> new Link(each.sender(""), each.topic(), true)).collect(Collectors.toSet()).stream().toList();
  }
}
