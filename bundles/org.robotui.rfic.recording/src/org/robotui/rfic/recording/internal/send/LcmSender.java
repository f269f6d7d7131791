package org.robotui.rfic.recording.internal.send;

import java.io.IOException;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import org.robotui.lcm.Lcm;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmState;
import org.robotui.lcm.LcmUrl;
import org.robotui.recording.RecordedMessage;

/** Sends over LCM, as {@code lcm-logplayer} does. */
final class LcmSender implements FrameworkSender {
  static final String ENCODING = "lcm";
  private static final int PATIENCE_SECONDS = 5;

  private final Lcm lcm;

  private LcmSender(Lcm lcm) {
    this.lcm = lcm;
  }

  /** Connects to the network that the environment names, else to LCM's own. */
  static LcmSender open(Map<String, String> variables, ThreadFactory threads)
      throws IOException, InterruptedException {
    CountDownLatch connected = new CountDownLatch(1);
    LcmUrl url = LcmUrl.of(variables);
    Lcm lcm = Lcm.open(url, LcmOptions.standard(threads).withStates(state -> {
      if (state instanceof LcmState.Connected) {
        connected.countDown();
      }
    }));
    try {
      if (!connected.await(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
        throw new IOException("LCM cannot be reached at " + url
            + (lcm.state() instanceof LcmState.Failed failed ? ": " + failed.reason() : "")
            + "; LCM_DEFAULT_URL names another place");
      }
      return new LcmSender(lcm);
    } catch (IOException | InterruptedException e) {
      lcm.close();
      throw e;
    }
  }

  @Override
  public void send(RecordedMessage message) throws IOException {
    lcm.publish(message.channel().topic(), message.data().duplicate());
  }

  @Override
  public void clock(long nanos) {
    // LCM has no message that says the time
  }

  /** Nobody says that he listens. */
  @Override
  public boolean isHeard() {
    return true;
  }

  @Override
  public void finish() {
    // it is sent when it is published
  }

  @Override
  public void close() {
    lcm.close();
  }
}
