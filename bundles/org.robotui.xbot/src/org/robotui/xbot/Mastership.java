package org.robotui.xbot;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import org.robotui.xbot.internal.Layout;
import org.robotui.xbot.internal.NativeClient;
import org.robotui.xbot.internal.References;

/**
 * The right to tell the joints what to do, while the communication plugin runs. It has a connection of its own, so that
 * no request delays a reference, and ends with it, also when this process dies.
 */
public final class Mastership implements AutoCloseable {
  private static final Duration TIMEOUT = Duration.ofSeconds(2);

  private final NativeClient client;
  private final References references;
  private final int joints;

  private Mastership(NativeClient client, References references, int joints) {
    this.client = client;
    this.references = references;
    this.joints = joints;
  }

  static Mastership take(String robot, Layout layout, int joints, Duration silence) throws IOException {
    NativeClient client = NativeClient.connect(robot, TIMEOUT);
    String seconds = String.format(Locale.ROOT, "%.3f", silence.toNanos() / 1e9);
    Answer answer = client.request("take " + seconds, TIMEOUT);
    if (!answer.ok()) {
      client.close();
      throw new IOException(answer.text());
    }
    return new Mastership(client, new References(layout), joints);
  }

  /**
   * Sends references, which hold for 200 ms; joints that are not named are told nothing. Does not wait for an answer.
   *
   * @param wanted of joints that the board has
   * @return false where the supervisor is gone
   * @throws IOException where this has ended, or a joint is not on the board
   */
  public synchronized boolean send(List<JointReference> wanted) throws IOException {
    for (JointReference reference : wanted) {
      if (reference.joint() < 0 || reference.joint() >= joints) {
        throw new IOException("there is no joint " + reference.joint() + ": the robot has " + joints);
      }
    }
    return client.reference(references.write(wanted, joints), joints);
  }

  /** Gives it back. */
  @Override
  public synchronized void close() {
    try {
      client.request("release", TIMEOUT);
    } catch (IOException e) {
      // It had ended before.
    } finally {
      client.close();
    }
  }
}
