package org.robotui.gazebo;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import org.robotui.gazebo.internal.NodeCore;
import org.robotui.net.call.Outcome;
import org.robotui.web.ArrivalSubscription;

/**
 * A node of its own process, as others see it. It says who it is by multicast, and hears who else is there. Of each
 * subscription only as many messages are kept as was asked for, the newest, until they are taken by a thread of their
 * own; nobody who publishes waits for it. Safe for all threads.
 */
public final class GazeboNode implements AutoCloseable {
  private final NodeCore core;
  private final String partition;

  private GazeboNode(NodeCore core, String partition) {
    this.core = core;
    this.partition = partition;
  }

  /**
   * Begins. Others are heard of some time later, at the latest after a second.
   *
   * @param options where, and as what
   * @param listener hears what happens
   * @return the node
   * @throws IOException where the addresses cannot be used; says why
   */
  public static GazeboNode open(GazeboOptions options, GazeboListener listener) throws IOException {
    QualifiedName.checkPartition(options.partition());
    return new GazeboNode(new NodeCore(options, listener), options.partition());
  }

  /**
   * What the other processes of the partition have now.
   *
   * @return all of it
   */
  public GazeboGraph graph() {
    return core.graph();
  }

  /**
   * Receives a topic from now on, from all who publish it, now or later.
   *
   * @param topic its name, with a slash at its begin
   * @param type the full name of the type; messages of others are not received
   * @param most how many messages are kept until they are taken; 1 where only the newest counts. No more than 32 MiB
   * are kept, but for one message
   * @param receiver takes them, on a thread that all subscriptions share
   * @return the subscription; closing it ends it
   */
  public ArrivalSubscription subscribe(String topic, String type, int most, GazeboReceiver receiver) {
    return core.subscribe(full(topic), type, most, receiver);
  }

  /**
   * Announces a topic of ours.
   *
   * @param topic its name, with a slash at its begin
   * @param type the full name of the type of its messages
   * @return what publishes on it; closing it takes it back
   */
  public GazeboPublisher advertise(String topic, String type) {
    String full = full(topic);
    core.publishes(full, type, true);
    return new GazeboPublisher(payload -> core.publish(full, type, payload), () -> core.subscribers(full, type),
        () -> core.publishes(full, type, false));
  }

  /**
   * Asks a service, which blocks. One that never answers is only told.
   *
   * @param service one of {@link GazeboGraph#services}
   * @param request the request
   * @param patience how long to wait
   * @return the response, empty where none comes, or why there is none
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<ByteBuffer> ask(OfferedService service, byte[] request, Duration patience)
      throws InterruptedException {
    return core.ask(service, request, patience);
  }

  /**
   * Answers a service from now on.
   *
   * @param service its name, with a slash at its begin
   * @param request the full name of the type of requests
   * @param response likewise of responses
   * @param responder answers
   * @return ends it when it is run
   */
  public Runnable serve(String service, String request, String response, GazeboResponder responder) {
    return core.serve(full(service), request, response, responder);
  }

  private String full(String name) {
    return new QualifiedName(partition, name).text();
  }

  /**
   * Where this node publishes, which is the sender of its messages.
   *
   * @return such as {@code tcp://127.0.0.1:40001}
   */
  public String address() {
    return core.address();
  }

  /** Takes back all that was announced, sends what was published, and ends, in at most two seconds. */
  @Override
  public void close() {
    core.close();
  }
}
