package org.robotui.lcm.tests;

import java.nio.ByteBuffer;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import org.robotui.lcm.Lcm;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmState;
import org.robotui.lcm.LcmUrl;
import org.robotui.lcm.SubscriptionOptions;

/**
 * A process with our client: URL {@code send CHANNEL SIZE,SIZE... COUNT PAUSE} sends so many messages of these sizes in
 * turn, with so many microseconds between them, once it is told to, then END until it is killed; URL
 * {@code receive CHANNELS} counts until END comes. The stock peers beside this class do the same.
 */
final class OurPeer {

  private OurPeer() {}

  public static void main(String[] arguments) throws Exception {
    try (Lcm lcm = Lcm.open(LcmUrl.of(arguments[0]), LcmOptions.standard(Thread.ofPlatform().daemon().factory()))) {
      while (!(lcm.state() instanceof LcmState.Connected)) {
        LockSupport.parkNanos(1_000_000);
      }
      if (arguments[1].equals("send")) {
        send(lcm, arguments[2], arguments[3].split(","), Integer.parseInt(arguments[4]), Long.parseLong(arguments[5]));
      } else {
        receive(lcm, arguments[2]);
      }
    }
  }

  private static void send(Lcm lcm, String channel, String[] sizes, int count, long pause) throws Exception {
    System.out.println("ready");
    System.in.read();
    for (int i = 0; i < count; i++) {
      lcm.publish(channel, filled(Integer.parseInt(sizes[i % sizes.length]), i));
      LockSupport.parkNanos(pause * 1000);
    }
    System.out.println("sent " + count);
    while (true) {
      lcm.publish("END", ByteBuffer.allocate(4));
      LockSupport.parkNanos(50_000_000);
    }
  }

  private static ByteBuffer filled(int size, int number) {
    ByteBuffer data = ByteBuffer.allocate(size);
    for (int at = 0; at < data.capacity(); at++) {
      data.put(at, (byte) (at * 31 + number));
    }
    return data.clear();
  }

  private static void receive(Lcm lcm, String channels) throws InterruptedException {
    AtomicInteger received = new AtomicInteger();
    AtomicInteger bad = new AtomicInteger();
    CountDownLatch end = new CountDownLatch(1);
    lcm.subscribe(channels, new SubscriptionOptions(10_000, 1L << 40), message -> {
      received.incrementAndGet();
      bad.addAndGet(isWhole(message.data()) ? 0 : 1);
    });
    lcm.subscribe("END", SubscriptionOptions.direct(), message -> end.countDown());
    System.out.println("ready");
    end.await();
    // what is in the queue, fragments that are still on their way, and the time after which a message is given up
    for (long before = -1; before < received.get();) {
      before = received.get();
      LockSupport.parkNanos(1_500_000_000);
    }
    System.out.println("received " + received + " bad " + bad + " missing "
        + (lcm.statistics().lost() + lcm.statistics().incomplete()));
    System.out.println(lcm.state() + " " + lcm.statistics());
  }

  private static boolean isWhole(ByteBuffer data) {
    int number = data.get(0);
    for (int at = 0; at < data.limit(); at++) {
      if (data.get(at) != (byte) (at * 31 + number)) {
        return false;
      }
    }
    return true;
  }
}
