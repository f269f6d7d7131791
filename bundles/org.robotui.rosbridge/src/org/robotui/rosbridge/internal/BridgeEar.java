package org.robotui.rosbridge.internal;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.net.call.Outcome;
import org.robotui.net.log.PeerText;
import org.robotui.rosbridge.BridgeListener;
import org.robotui.web.Arrivals;
import org.robotui.web.OpenQuestions;
import org.robotui.web.WebListener;
import org.robotui.web.tree.Cbor;
import org.robotui.web.tree.JsonText;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

/** Hears a bridge. What nobody can read is told and ignored. */
public final class BridgeEar implements WebListener {

  private final String server;
  private final BridgeListener listener;
  private final Map<String, List<Arrivals.Source<Parcel>>> topics = new ConcurrentHashMap<>();
  private final OpenQuestions<Map<String, Object>> calls = new OpenQuestions<>();
  private final Map<String, Served> services = new ConcurrentHashMap<>();

  /** A service of ours. */
  @FunctionalInterface
  public interface Served {
    /** Somebody calls it. */
    void asked(Object id, Map<String, Object> arguments);
  }

  /** Nothing was heard yet. */
  public BridgeEar(String server, BridgeListener listener) {
    this.server = server;
    this.listener = listener;
  }

  /** The calls under way. */
  public OpenQuestions<Map<String, Object>> calls() {
    return calls;
  }

  /** The services of ours, by name. */
  public Map<String, Served> services() {
    return services;
  }

  /** Who takes messages, by topic. */
  public Map<String, List<Arrivals.Source<Parcel>>> topics() {
    return topics;
  }

  @Override
  public void onSkipped(String reason) {
    listener.onUnreadable(server + ": " + reason);
  }

  @Override
  public void onText(String text) {
    Optional<Map.Entry<String, String>> head = JsonText.peek(text, "op", "topic");
    if (head.isPresent() && head.get().getKey().equals("publish") && !head.get().getValue().isEmpty()) {
      arrived(head.get().getValue(), new Parcel.Text(text, System.nanoTime()));
      return;
    }
    try {
      said(Trees.object(JsonText.read(text)), text.length());
    } catch (TreeException e) {
      onSkipped("'" + PeerText.name(text) + "' cannot be read: " + PeerText.brief(e.getMessage()));
    }
  }

  @Override
  public void onBinary(ByteBuffer bytes) {
    try {
      said(Trees.object(Cbor.read(bytes)), bytes.remaining());
    } catch (TreeException e) {
      onSkipped("a message in CBOR cannot be read: " + PeerText.brief(e.getMessage()));
    }
  }

  private void arrived(String topic, Parcel parcel) {
    topics.getOrDefault(topic, List.of()).forEach(source -> source.arrived(parcel));
  }

  private void said(Map<String, Object> message, int size) throws TreeException {
    switch (Trees.text(message, "op")) {
      case "publish" -> arrived(Trees.text(message, "topic"), new Parcel.Tree(message, size, System.nanoTime()));
      case "service_response" -> calls.answered(Trees.optionalText(message, "id").orElse(""), response(message));
      case "call_service" -> called(message);
      case "status" -> listener.onStatus(Trees.optionalText(message, "level").orElse("error"),
          PeerText.brief(Trees.optionalText(message, "msg").orElse("")));
      default -> {
        // of a newer protocol, or nothing that was asked for
      }
    }
  }

  private void called(Map<String, Object> message) throws TreeException {
    Served served = services.get(Trees.text(message, "service"));
    if (served != null) {
      served.asked(message.getOrDefault("id", ""),
          message.get("args") instanceof Map<?, ?> ? Trees.object(message.get("args")) : Map.of());
    }
  }

  /** Bridges say a failure in words, in place of the values. */
  private static Outcome<Map<String, Object>> response(Map<String, Object> message) throws TreeException {
    return Boolean.FALSE.equals(message.get("result"))
        ? new Outcome.Refused<>(PeerText.brief(String.valueOf(message.get("values"))))
        : new Outcome.Done<>(message.get("values") instanceof Map<?, ?> ? Trees.object(message.get("values"))
            : Map.of());
  }
}
