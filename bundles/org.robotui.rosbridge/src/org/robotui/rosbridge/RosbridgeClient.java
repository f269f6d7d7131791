package org.robotui.rosbridge;

import java.io.IOException;
import java.net.URI;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ThreadFactory;
import org.robotui.net.call.Outcome;
import org.robotui.rosbridge.internal.BridgeEar;
import org.robotui.rosbridge.internal.Parcel;
import org.robotui.rosbridge.internal.Words;
import org.robotui.web.ArrivalSubscription;
import org.robotui.web.Arrivals;
import org.robotui.web.LinkMonitor;
import org.robotui.web.WebLink;
import org.robotui.web.WebOptions;
import org.robotui.web.tree.TreeException;

/**
 * A client of one bridge. Of each subscription only as many messages are kept as was asked for, the newest, until they
 * are taken by a thread of their own; what is published goes out before all else that waits, or not at all. Safe for
 * all threads.
 */
public final class RosbridgeClient implements AutoCloseable {

  private static final long MOST_BYTES = 1 << 25;

  private final WebLink link;
  private final BridgeEar ear;
  private final Arrivals arrivals;
  private final List<BridgePublisher> published = new CopyOnWriteArrayList<>();
  private final Map<String, Integer> advertised = new HashMap<>();

  private RosbridgeClient(WebLink link, BridgeEar ear, Arrivals arrivals) {
    this.link = link;
    this.ear = ear;
    this.arrivals = arrivals;
  }

  /**
   * Connects, which blocks.
   *
   * @param address such as {@code ws://robot:9090}
   * @param threads makes the threads of the client
   * @param listener hears what the bridge says
   * @return the client
   * @throws IOException if there is no such bridge; says who and why
   * @throws InterruptedException if the thread was interrupted
   */
  public static RosbridgeClient open(URI address, ThreadFactory threads, BridgeListener listener)
      throws IOException, InterruptedException {
    BridgeEar ear = new BridgeEar(address.toString(), listener);
    WebLink link = WebLink.open(address, WebOptions.standard(threads), ear);
    link.whenEnded().thenAccept(ear.calls()::end);
    return new RosbridgeClient(link, ear, new Arrivals(threads));
  }

  /**
   * Receives a topic from now on. Several may receive the same one: the bridge is asked once, as the first one asks.
   *
   * @param topic its name
   * @param type the type of its messages; empty where the bridge knows it
   * @param options what the bridge is asked for
   * @param receiver takes the messages, on a thread that all subscriptions share
   * @return the subscription; closing it ends it
   */
  public ArrivalSubscription subscribe(String topic, String type, SubscriptionOptions options,
      BridgeReceiver receiver) {
    Arrivals.Source<Parcel> source =
        arrivals.source(options.most(), MOST_BYTES, Parcel::size, parcel -> taken(parcel, receiver));
    synchronized (ear) {
      List<Arrivals.Source<Parcel>> sources = ear.topics().computeIfAbsent(topic, t -> new CopyOnWriteArrayList<>());
      sources.add(source);
      if (sources.size() == 1) {
        link.say(type.isEmpty()
            ? Words.of("subscribe", "id", topic, "topic", topic, "throttle_rate", options.throttleMillis(),
                "queue_length", options.most(), "compression", options.compression())
            : Words.of("subscribe", "id", topic, "topic", topic, "type", type, "throttle_rate",
                options.throttleMillis(), "queue_length", options.most(), "compression", options.compression()));
      }
    }
    return new ArrivalSubscription(source, () -> unsubscribe(topic, source));
  }

  private static void taken(Parcel parcel, BridgeReceiver receiver) {
    BridgeMessage message;
    try {
      message = parcel.open();
    } catch (TreeException e) {
      receiver.unreadable(String.valueOf(e.getMessage()), parcel.receivedNanos());
      return;
    }
    receiver.received(message, parcel.receivedNanos());
  }

  private void unsubscribe(String topic, Arrivals.Source<Parcel> source) {
    synchronized (ear) {
      List<Arrivals.Source<Parcel>> sources = ear.topics().getOrDefault(topic, List.of());
      if (sources.remove(source) && sources.isEmpty()) {
        ear.topics().remove(topic);
        link.say(Words.of("unsubscribe", "id", topic, "topic", topic));
      }
    }
  }

  /**
   * Announces a topic of our own.
   *
   * @param topic its name
   * @param type the type of its messages
   * @return what publishes it; closing it takes it back
   */
  public BridgePublisher advertise(String topic, String type) {
    synchronized (advertised) {
      if (advertised.merge(topic, 1, Integer::sum) == 1) {
        link.say(Words.of("advertise", "id", topic, "topic", topic, "type", type));
      }
    }
    BridgePublisher publisher = new BridgePublisher(link, topic, this::unadvertise);
    published.add(publisher);
    return publisher;
  }

  private void unadvertise(BridgePublisher publisher) {
    if (!published.remove(publisher)) {
      return;
    }
    synchronized (advertised) {
      if (advertised.merge(publisher.topic(), -1, Integer::sum) == 0) {
        advertised.remove(publisher.topic());
        link.say(Words.of("unadvertise", "id", publisher.topic(), "topic", publisher.topic()));
      }
    }
  }

  /**
   * Calls a service, which blocks.
   *
   * @param service its name
   * @param arguments the fields of the request by name
   * @param patience how long to wait
   * @return the fields of the response, or why there is none
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<Map<String, Object>> call(String service, Map<String, Object> arguments, Duration patience)
      throws InterruptedException {
    return ear.calls().ask(service, patience, id -> link
        .say(Words.of("call_service", "id", String.valueOf(id), "service", service, "args", arguments)));
  }

  /**
   * Offers a service to the nodes behind the bridge. One of the same name takes its place.
   *
   * @param service its name
   * @param type the name of its type
   * @param responder answers calls
   * @return offers it no longer when closed
   */
  public BridgeResponder.Offered serve(String service, String type, BridgeResponder responder) {
    BridgeEar.Served served = (id, arguments) -> responder.answer(arguments)
        .thenAccept(answer -> link.say(Words.of("service_response", "id", id, "service", service, "values",
            answer.values(), "result", answer.result())));
    ear.services().put(service, served);
    link.say(Words.of("advertise_service", "type", type, "service", service));
    return () -> {
      if (ear.services().remove(service, served)) {
        link.say(Words.of("unadvertise_service", "service", service));
      }
    };
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
    new ArrayList<>(published).forEach(BridgePublisher::close);
    arrivals.close();
    link.close();
  }
}
