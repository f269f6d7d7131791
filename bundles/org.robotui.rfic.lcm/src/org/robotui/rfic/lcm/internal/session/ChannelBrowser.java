package org.robotui.rfic.lcm.internal.session;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.lcm.Lcm;
import org.robotui.lcm.LcmStatistics;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.lcm.type.TypeText;
import org.robotui.message.lcm.TypeShapes;

/** What was heard. LCM has no master to ask: programs are known by the addresses from which they send. */
final class ChannelBrowser implements Browser {
  private static final String OURSELVES = "robotui";

  private final LcmChannels channels;
  private final TypeLibrary types;
  private final Lcm lcm;

  ChannelBrowser(LcmChannels channels, TypeLibrary types, Lcm lcm) {
    this.channels = channels;
    this.types = types;
    this.lcm = lcm;
  }

  private List<Channel> heard() {
    return channels.all().stream().filter(c -> c.heard().messages() > 0).toList();
  }

  @Override
  public List<Item> list(Kind kind) {
    return switch (kind) {
      case TOPIC -> heard().stream().map(c -> new Item(kind, c.name(), c.typeName())).toList();
      case NODE -> Stream.concat(Stream.of(OURSELVES), heard().stream().flatMap(c -> c.heard().senders().stream()))
          .distinct().sorted().map(n -> new Item(kind, n, "")).toList();
      default -> List.of();
    };
  }

  @Override
  public Description describe(Item item) throws CallException {
    return switch (item.kind()) {
      case TOPIC -> channel(item);
      case NODE -> plain(item, item.name().equals(OURSELVES) ? ourselves() : sender(item.name()));
      default -> throw new CallException("LCM has no such thing");
    };
  }

  private Description channel(Item item) throws CallException {
    Channel channel =
        channels.find(item.name()).orElseThrow(() -> new CallException("nothing was heard on " + item.name()));
    Tally.Heard heard = channel.heard();
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("type", channel.typeName());
    facts.put("fingerprint", channel.fingerprint().isEmpty() ? "none" : channel.fingerprint());
    if (!channel.remedy().isEmpty()) {
      facts.put("problem", channel.remedy());
    }
    facts.put("messages", Long.toString(heard.messages()));
    facts.put("rate", String.format(Locale.ROOT, "%.1f Hz", heard.hertz()));
    facts.put("size", heard.size() + " bytes, " + heard.bytes() + " all together");
    facts.put("senders", heard.senders().stream().sorted().collect(Collectors.joining(", ")));
    Optional<LcmType> type = channel.type();
    return new Description(item, facts, type.map(t -> TypeText.of(t, types)), type.map(t -> TypeShapes.of(t, types)),
        Optional.empty());
  }

  private Map<String, String> sender(String name) {
    return Map.of("sends", heard().stream().filter(c -> c.heard().senders().contains(name)).map(Channel::name)
        .collect(Collectors.joining(", ")));
  }

  private Map<String, String> ourselves() {
    LcmStatistics s = lcm.statistics();
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("url", lcm.url().toString());
    facts.put("received", s.received() + " messages, " + s.receivedBytes() + " bytes");
    facts.put("sent", s.published() + " messages, " + s.publishedBytes() + " bytes");
    facts.put("lost",
        s.lost() + " never came, " + s.incomplete() + " came in part, " + s.dropped() + " dropped, " + s.damaged()
            + " damaged"
            + (s.lastDamage().isEmpty() ? "" : " (" + s.lastDamage() + ")"));
    if (s.receiveBufferWanted() > 0) {
      String remedy = LinkWatch.bufferRemedy(s);
      facts.put("receive buffer", remedy.isEmpty() ? s.receiveBuffer() + " bytes" : remedy);
    }
    facts.put("types", Integer.toString(types.types().size()));
    if (!types.problems().isEmpty()) {
      facts.put("wrong in .lcm files",
          types.problems().stream().map(Exception::getMessage).collect(Collectors.joining("; ")));
    }
    return facts;
  }

  private static Description plain(Item item, Map<String, String> facts) {
    return new Description(item, facts, Optional.empty(), Optional.empty(), Optional.empty());
  }

  @Override
  public List<Link> links() {
    return heard().stream().flatMap(c -> c.heard().senders().stream().map(s -> new Link(s, c.name(), true))).toList();
  }

  @Override
  public Optional<Object> parameter(String name) {
    return Optional.empty();
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    throw new CallException("robots that speak LCM have no parameters");
  }

  @Override
  public List<Tunable> tunables(Item item) throws CallException {
    throw new CallException("robots that speak LCM have no such settings");
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    throw new CallException("robots that speak LCM have no such settings");
  }
}
