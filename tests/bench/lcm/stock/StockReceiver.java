import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Locale;
import lcm.lcm.LCM;
import lcm.lcm.LCMDataInputStream;
import lcm.lcm.LCMSubscriber;

/** Counts messages with the stock Java client and says at each END what came since the last one. */
public final class StockReceiver implements LCMSubscriber {
  private long messages;
  private long bytes;
  private long first;
  private long last;
  private byte told;

  public static void main(String[] arguments) throws Exception {
    LCM lcm = new LCM(arguments[0]);
    StockReceiver counts = new StockReceiver();
    lcm.subscribe("DATA", counts);
    lcm.subscribe("END", counts);
    System.out.println("\"ready\"");
    Thread.sleep(Long.MAX_VALUE);
  }

  @Override
  public void messageReceived(LCM lcm, String channel, LCMDataInputStream in) {
    if (channel.equals("END")) {
      try {
        end(in.readByte());
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
      return;
    }
    last = System.nanoTime();
    if (messages++ == 0) {
      first = last;
    }
    bytes += in.available();
  }

  private void end(byte flood) {
    if (flood != told) {
      told = flood;
      System.out.printf(Locale.ROOT, "{\"messages\": %d, \"bytes\": %d, \"seconds\": %.9f}%n", messages, bytes,
          (last - first) / 1e9);
      messages = 0;
      bytes = 0;
      first = 0;
      last = 0;
    }
  }
}
