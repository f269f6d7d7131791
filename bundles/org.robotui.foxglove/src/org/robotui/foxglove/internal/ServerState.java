package org.robotui.foxglove.internal;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.robotui.foxglove.ServerChannel;
import org.robotui.foxglove.FoxgloveListener;
import org.robotui.foxglove.Parameter;
import org.robotui.foxglove.ServerInfo;
import org.robotui.foxglove.Service;
import org.robotui.net.call.Outcome;
import org.robotui.net.log.PeerText;
import org.robotui.web.OpenQuestions;
import org.robotui.web.WebListener;
import org.robotui.web.tree.JsonText;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

/** Hears a server and remembers what it has. What nobody can read is told and ignored. */
public final class ServerState implements WebListener {

  private static final int MOST = 20_000;
  private static final Set<String> OFFERS =
      Set.of("serverInfo", "advertise", "unadvertise", "advertiseServices", "unadvertiseServices");

  private final String server;
  private final FoxgloveListener listener;
  private final Map<Long, ServerChannel> channels = new ConcurrentHashMap<>();
  private final Map<Long, Service> services = new ConcurrentHashMap<>();
  private final Map<Long, Consumer<Binary.Data>> subscriptions = new ConcurrentHashMap<>();
  private final OpenQuestions<ByteBuffer> calls = new OpenQuestions<>();
  private final OpenQuestions<List<Parameter>> parameters = new OpenQuestions<>();
  private final Graph graph = new Graph();
  private volatile Optional<ServerInfo> info = Optional.empty();

  /** Nothing was heard yet. */
  public ServerState(String server, FoxgloveListener listener) {
    this.server = server;
    this.listener = listener;
  }

  /** What the server says of itself, once it has. */
  public Optional<ServerInfo> info() {
    return info;
  }

  /** The channels now. */
  public List<ServerChannel> channels() {
    return List.copyOf(channels.values());
  }

  /** The services now. */
  public List<Service> services() {
    return List.copyOf(services.values());
  }

  /** The calls under way. */
  public OpenQuestions<ByteBuffer> calls() {
    return calls;
  }

  /** The questions for parameters under way. */
  public OpenQuestions<List<Parameter>> parameters() {
    return parameters;
  }

  /** Messages of a subscription go there from now on. */
  public void subscribed(long id, Consumer<Binary.Data> taker) {
    subscriptions.put(id, taker);
  }

  /** Nothing more of a subscription is taken. */
  public void unsubscribed(long id) {
    subscriptions.remove(id);
  }

  /** Nothing more comes. */
  public void ended(String reason) {
    calls.end(reason);
    parameters.end(reason);
  }

  @Override
  public void onSkipped(String reason) {
    listener.onUnreadable(server + ": " + reason);
  }

  @Override
  public void onBinary(ByteBuffer bytes) {
    try {
      switch (Binary.read(bytes)) {
        case Binary.Data data -> Optional.ofNullable(subscriptions.get(data.subscription()))
            .ifPresent(taker -> taker.accept(data));
        case Binary.Time time -> listener.onTime(time.nanos());
        case Binary.Reply reply -> calls.answered(String.valueOf(reply.call()), new Outcome.Done<>(reply.payload()));
        case Binary.Other other -> {
          // of a newer protocol
        }
      }
    } catch (TreeException e) {
      onSkipped(e.getMessage());
    }
  }

  @Override
  public void onText(String text) {
    try {
      Map<String, Object> message = Trees.object(JsonText.read(text));
      said(Trees.text(message, "op"), message);
    } catch (TreeException e) {
      onSkipped("'" + PeerText.name(text) + "' cannot be read: " + PeerText.brief(e.getMessage()));
    }
  }

  private void said(String op, Map<String, Object> message) throws TreeException {
    try {
      take(op, message);
    } finally {
      if (OFFERS.contains(op)) {
        listener.onOffers();
      }
    }
  }

  private void take(String op, Map<String, Object> message) throws TreeException {
    switch (op) {
      case "serverInfo" -> introduced(Advertised.info(message));
      case "advertise" -> {
        for (Object each : Trees.list(message, "channels")) {
          ServerChannel channel = Advertised.channel(Trees.object(each));
          remember(channels, channel.id(), channel);
        }
      }
      case "unadvertise" -> Trees.list(message, "channelIds").forEach(channels::remove);
      case "advertiseServices" -> {
        for (Object each : Trees.list(message, "services")) {
          Service service = Advertised.service(Trees.object(each));
          remember(services, service.id(), service);
        }
      }
      case "unadvertiseServices" -> Trees.list(message, "serviceIds").forEach(services::remove);
      case "parameterValues" -> told(Trees.optionalText(message, "id").orElse(""), values(message));
      case "serviceCallFailure" -> calls.answered(String.valueOf(Trees.whole(message, "callId")),
          new Outcome.Refused<>(PeerText.brief(Trees.optionalText(message, "message").orElse("no reason given"))));
      case "connectionGraphUpdate" -> {
        graph.update(message);
        listener.onGraph(graph.publishers(), graph.subscribers());
      }
      case "status" -> listener.onStatus((int) Trees.whole(message, "level"),
          PeerText.brief(Trees.optionalText(message, "message").orElse("")));
      default -> {
        // of a newer protocol
      }
    }
  }

  /** Values that nobody has asked for are those of parameters that are followed. */
  private void told(String id, List<Parameter> values) {
    if (id.isEmpty()) {
      listener.onParameters(values);
    } else {
      parameters.answered(id, new Outcome.Done<>(values));
    }
  }

  /** A server that introduces itself again has begun anew: what it had before it may not have any more. */
  private void introduced(ServerInfo now) {
    if (info.isPresent()) {
      channels.clear();
      services.clear();
    }
    info = Optional.of(now);
  }

  private static <T> void remember(Map<Long, T> all, long id, T value) throws TreeException {
    if (all.size() >= MOST) {
      throw new TreeException("more than " + MOST + " are offered");
    }
    all.put(id, value);
  }

  private static List<Parameter> values(Map<String, Object> message) throws TreeException {
    List<Parameter> values = new ArrayList<>();
    for (Object each : Trees.list(message, "parameters")) {
      Map<String, Object> parameter = Trees.object(each);
      if (parameter.containsKey("value")) {
        values.add(new Parameter(Trees.text(parameter, "name"), parameter.get("value"),
            Trees.optionalText(parameter, "type").orElse("")));
      }
    }
    return values;
  }
}
