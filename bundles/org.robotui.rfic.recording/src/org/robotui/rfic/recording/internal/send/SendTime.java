package org.robotui.rfic.recording.internal.send;

/** The time by which messages are sent. */
interface SendTime {
  /** That of this machine. */
  SendTime REAL = new SendTime() {
    @Override
    public long nanos() {
      return System.nanoTime();
    }

    @Override
    public void pass(long nanos) throws InterruptedException {
      Thread.sleep(nanos / 1_000_000L, (int) (nanos % 1_000_000L));
    }
  };

  /** Any time that only goes on. */
  long nanos();

  /** Waits for a while, above 0. */
  void pass(long nanos) throws InterruptedException;
}
