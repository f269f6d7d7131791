package org.robotui.rfic.xbot.internal;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import java.util.stream.IntStream;
import org.robotui.api.port.CommandSink;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointMode;
import org.robotui.xbot.Board;
import org.robotui.xbot.JointReference;
import org.robotui.xbot.Mastership;
import org.robotui.xbot.RtClient;
import org.robotui.xbot.StateFrame;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Sends references while somebody commands: the first command makes us the master, the stop or a silence ends it. All
 * checks of who may command were made before, by the arbiter; the control checks every number again. To become the
 * master and to end it are requests that a busy control may be long in answering: they have a thread of their own, so
 * that nobody who commands waits.
 */
final class XbotCommands implements CommandSink<JointCommand>, AutoCloseable {
  private static final Duration SILENCE = Duration.ofSeconds(1);
  private static final List<JointReference> RELEASE = List.of();
  private static final Logger LOG = LoggerFactory.getLogger(XbotCommands.class);

  private final RtClient client;
  private final Thread worker;
  private Optional<List<JointReference>> next = Optional.empty();
  private Optional<String> failure = Optional.empty();
  private Optional<Mastership> mastership = Optional.empty();

  XbotCommands(RtClient client, ThreadFactory threads) {
    this.client = client;
    worker = threads.newThread(this::work);
    worker.start();
  }

  @Override
  public Sent send(JointCommand command) {
    try {
      return command.joints().isEmpty() ? put(RELEASE) : put(references(command, names()));
    } catch (IOException e) {
      put(RELEASE);
      return new Sent.Refused(e.getMessage());
    }
  }

  private List<String> names() throws IOException {
    Board board = client.board().orElseThrow(() -> new IOException("the control says nothing that can be read"));
    return board.joints().stream().map(Board.Joint::name).toList();
  }

  /** The newest counts alone. What became of the one before is told with the next, unless nobody commands any more. */
  private synchronized Sent put(List<JointReference> references) {
    Optional<String> before = failure.filter(why -> !references.isEmpty());
    failure = Optional.empty();
    next = Optional.of(before.isPresent() ? RELEASE : references);
    notifyAll();
    return before.<Sent>map(Sent.Refused::new).orElseGet(Sent.Out::new);
  }

  static List<JointReference> references(JointCommand command, List<String> names) throws IOException {
    List<JointReference> references = new ArrayList<>();
    for (JointCommand.Joint joint : command.joints()) {
      int index = IntStream.range(0, names.size()).filter(i -> names.get(i).equals(joint.name())).findFirst()
          .orElseThrow(() -> new IOException("there is no joint " + joint.name()));
      JointControl.Reference reference = joint.reference();
      references.add(new JointReference(index, new StateFrame.Reference(reference.position(), reference.velocity(),
          reference.effort(), reference.stiffness(), reference.damping()),
          joint.modes().stream().mapToInt(JointMode::bit).sum()));
    }
    return references;
  }

  private void work() {
    try {
      while (true) {
        order(await());
      }
    } catch (InterruptedException e) {
      LOG.debug("nobody commands any more");
    } finally {
      end();
    }
  }

  /** A silence is a release, so that another master may command again. */
  private synchronized List<JointReference> await() throws InterruptedException {
    long end = System.nanoTime() + SILENCE.toNanos();
    while (next.isEmpty() && System.nanoTime() < end) {
      wait(Math.max(1, (end - System.nanoTime()) / 1_000_000));
    }
    return poll().orElse(RELEASE);
  }

  private synchronized Optional<List<JointReference>> poll() {
    Optional<List<JointReference>> newest = next;
    next = Optional.empty();
    return newest;
  }

  private void order(List<JointReference> references) {
    if (references.isEmpty()) {
      end();
      return;
    }
    try {
      if (mastership.isEmpty()) {
        mastership = Optional.of(client.take(SILENCE));
        // That may have taken its time: what was said since counts, above all that nothing is said any more.
        send(poll().orElse(references));
      } else {
        send(references);
      }
    } catch (IOException e) {
      fail(e.getMessage());
    }
  }

  private void send(List<JointReference> references) throws IOException {
    if (references.isEmpty()) {
      end();
    } else if (!mastership.orElseThrow().send(references)) {
      fail("the real-time control has ended");
    }
  }

  private void fail(String why) {
    end();
    synchronized (this) {
      failure = Optional.of(why);
    }
  }

  private void end() {
    mastership.ifPresent(Mastership::close);
    mastership = Optional.empty();
  }

  @Override
  public void close() {
    worker.interrupt();
  }
}
