package org.robotui.foxglove;

import java.io.IOException;
import java.net.URI;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.foxglove.internal.Binary;
import org.robotui.foxglove.internal.ChannelFeeds;
import org.robotui.foxglove.internal.Graph;
import org.robotui.foxglove.internal.ServerState;
import org.robotui.net.call.Outcome;
import org.robotui.web.ArrivalSubscription;
import org.robotui.web.Arrivals;
import org.robotui.web.LinkMonitor;
import org.robotui.web.OpenQuestions;
import org.robotui.web.WebLink;
import org.robotui.web.WebOptions;
import org.robotui.web.WebPayload;
import org.robotui.web.tree.JsonText;

/**
 * A client of one server. Of each subscription only as many messages are kept as was asked for, the newest, until they
 * are taken by a thread of their own; what is published goes out before all else that waits, or not at all. Safe for
 * all threads.
 */
public final class FoxgloveClient implements AutoCloseable {

  private static final String NEW = "foxglove.sdk.v1";
  private static final long MOST_BYTES = 1 << 25;
  private static final String OLD = "foxglove.websocket.v1";

  private final WebLink link;
  private final ServerState ear;
  private final Arrivals arrivals;
  private final ChannelFeeds feeds;
  private final AtomicInteger ids = new AtomicInteger();
  private final Map<Integer, ClientChannel> advertised = new ConcurrentHashMap<>();

  private FoxgloveClient(WebLink link, ServerState ear, Arrivals arrivals) {
    this.link = link;
    this.ear = ear;
    this.arrivals = arrivals;
    this.feeds = new ChannelFeeds(ear, this::say);
  }

  /**
   * Connects, which blocks. The server says who it is, and what it has, some time later.
   *
   * @param address such as {@code ws://robot:8765}
   * @param threads makes the threads of the client
   * @param listener hears what the server says
   * @return the client
   * @throws IOException if there is no such server; says who and why
   * @throws InterruptedException if the thread was interrupted
   */
  public static FoxgloveClient open(URI address, ThreadFactory threads, FoxgloveListener listener)
      throws IOException, InterruptedException {
    ServerState ear = new ServerState(address.toString(), listener);
    WebLink link = WebLink.open(address, WebOptions.standard(threads, NEW, OLD), ear);
    link.whenEnded().thenAccept(ear::ended);
    return new FoxgloveClient(link, ear, new Arrivals(threads));
  }

  /**
   * What the server says of itself.
   *
   * @return none until it has said it
   */
  public Optional<ServerInfo> info() {
    return ear.info();
  }

  /**
   * The protocol that was agreed on.
   *
   * @return its name
   */
  public String protocol() {
    return link.subprotocol();
  }

  /**
   * What it offers to send now.
   *
   * @return the channels
   */
  public List<ServerChannel> channels() {
    return ear.channels();
  }

  /**
   * What it can be asked now.
   *
   * @return the services
   */
  public List<Service> services() {
    return ear.services();
  }

  /**
   * Receives a channel from now on.
   *
   * @param channel one of {@link #channels}
   * @param most how many messages are kept until they are taken; 1 where only the newest counts. No more than 32 MiB
   * are kept, but for one message
   * @param receiver takes them, on a thread that all subscriptions share
   * @return the subscription; closing it ends it
   */
  public ArrivalSubscription subscribe(ServerChannel channel, int most, MessageReceiver receiver) {
    Arrivals.Source<Binary.Data> source = arrivals.source(most, MOST_BYTES, data -> data.payload().remaining(),
        data -> receiver.received(data.payload(), data.nanos(), data.receivedNanos()));
    feeds.add(channel.id(), source);
    return new ArrivalSubscription(source, () -> feeds.remove(channel.id(), source));
  }

  /**
   * Announces a channel of our own.
   *
   * @param topic its name
   * @param encoding of its messages, one of {@link ServerInfo#encodings}
   * @param type the name of its schema
   * @param schemaEncoding of its schema, or empty
   * @param schema its schema, or empty
   * @return the channel; closing it takes it back
   */
  public ClientChannel advertise(String topic, String encoding, String type, String schemaEncoding, String schema) {
    int id = ids.incrementAndGet();
    List<String> members = List.of("topic", topic, "encoding", encoding, "schemaName", type, "schemaEncoding",
        schemaEncoding, "schema", schema);
    Map<String, Object> channel = new ConcurrentHashMap<>(Map.of("id", id));
    for (int i = 0; i < members.size(); i += 2) {
      if (!members.get(i + 1).isEmpty()) {
        channel.put(members.get(i), members.get(i + 1));
      }
    }
    say(Graph.message("advertise", "channels", List.of(channel)));
    ClientChannel made = new ClientChannel(link, id, () -> {
      if (advertised.remove(id) != null) {
        say(Graph.message("unadvertise", "channelIds", List.of(id)));
      }
    });
    advertised.put(id, made);
    return made;
  }

  /**
   * Asks a service, which blocks.
   *
   * @param service one of {@link #services}
   * @param encoding of the request
   * @param request the request
   * @param patience how long to wait
   * @return the response, in the same encoding, or why there is none
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<ByteBuffer> call(Service service, String encoding, ByteBuffer request, Duration patience)
      throws InterruptedException {
    OpenQuestions<ByteBuffer> calls = ear.calls();
    return calls.ask(service.name(), patience,
        id -> link.say(new WebPayload.Binary(Binary.call(service.id(), id, encoding, request))));
  }

  /**
   * Reads parameters, which blocks.
   *
   * @param names which; all where it is empty
   * @param patience how long to wait
   * @return those that are set, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<List<Parameter>> parameters(List<String> names, Duration patience) throws InterruptedException {
    return ear.parameters().ask("the list of parameters", patience, id -> {
      Map<String, Object> message = Graph.message("getParameters", "parameterNames", names);
      message.put("id", String.valueOf(id));
      return say(message);
    });
  }

  /**
   * Sets a parameter, which blocks.
   *
   * @param parameter its name and value
   * @param patience how long to wait
   * @return what it is now, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<List<Parameter>> set(Parameter parameter, Duration patience) throws InterruptedException {
    return ear.parameters().ask(parameter.name(), patience, id -> {
      Map<String, Object> set = new LinkedHashMap<>(Map.of("name", parameter.name(), "value", parameter.value()));
      if (!parameter.type().isEmpty()) {
        set.put("type", parameter.type());
      }
      Map<String, Object> message = Graph.message("setParameters", "parameters", List.of(set));
      message.put("id", String.valueOf(id));
      return say(message);
    });
  }

  /**
   * Asks to be told when parameters change, or to be told no more.
   *
   * @param names which
   * @param follow whether to be told
   */
  public void followParameters(List<String> names, boolean follow) {
    say(Graph.message(follow ? "subscribeParameterUpdates" : "unsubscribeParameterUpdates", "parameterNames", names));
  }

  /** Asks to be told who publishes and subscribes what. Only where the server can say so. */
  public void followGraph() {
    say(Map.of("op", "subscribeConnectionGraph"));
  }

  private boolean say(Map<String, Object> message) {
    return link.say(new WebPayload.Text(JsonText.write(message)));
  }

  /**
   * How the link fares.
   *
   * @return lasts as long as the client
   */
  public LinkMonitor link() {
    return link;
  }

  /** Takes back what was announced, and ends the link. */
  @Override
  public void close() {
    new ArrayList<>(advertised.values()).forEach(ClientChannel::close);
    arrivals.close();
    link.close();
  }
}
