package org.robotui.uic.sound.internal.tone;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Plays one sound after the other, and speaks, on a thread that may block. Where nothing can be heard it says so once,
 * rings the bell instead, and tries the device again from time to time. Safe for all threads.
 */
public final class Player {
  /** Who has more to say at once is not understood anyway. */
  private static final int MOST_WAITING = 4;

  private static final long RETRY_NANOS = 30_000_000_000L;

  private final Executor executor;
  private final Supplier<Speaker> speakers;
  private final Runnable bell;
  private final Consumer<String> trouble;
  private final Deque<Piece> waiting = new ArrayDeque<>();
  private boolean running;
  private Optional<Speaker> speaker = Optional.empty();
  private final Voice voice;
  private String said = "";
  private String saidOfVoice = "";
  private long silentUntil = Long.MIN_VALUE;

  /**
   * A player.
   *
   * @param executor gives threads that may block
   * @param speakers makes the speaker, on such a thread; may fail to link where the platform has no sound
   * @param voice speaks, on such a thread
   * @param bell rings in place of a sound that cannot be heard
   * @param trouble is told why nothing can be heard, each reason once
   */
  public Player(Executor executor, Supplier<Speaker> speakers, Voice voice, Runnable bell,
      Consumer<String> trouble) {
    this.executor = executor;
    this.speakers = speakers;
    this.voice = voice;
    this.bell = bell;
    this.trouble = trouble;
  }

  /**
   * Plays a sound when those before it have ended. Returns at once.
   *
   * @param who for what it is played; what waits already is not played twice
   * @param sound what to play
   * @param volume 0 to 1
   * @param words what is spoken after it; empty for nothing
   */
  public void play(String who, Sound sound, double volume, String words) {
    synchronized (this) {
      boolean there = waiting.stream().anyMatch(piece -> piece.who().equals(who));
      if (there || waiting.size() >= MOST_WAITING) {
        return;
      }
      waiting.add(new Piece(who, sound, volume, words));
      if (running) {
        return;
      }
      running = true;
    }
    start();
  }

  private void start() {
    try {
      executor.execute(this::run);
    } catch (RejectedExecutionException e) {
      stop();
    }
  }

  private void run() {
    try {
      for (Optional<Piece> next = next(); next.isPresent(); next = next()) {
        play(next.get());
        speak(next.get().words());
      }
    } catch (InterruptedException e) {
      stop();
      Thread.currentThread().interrupt();
    }
  }

  private synchronized Optional<Piece> next() {
    Optional<Piece> next = Optional.ofNullable(waiting.poll());
    running = next.isPresent();
    return next;
  }

  private synchronized void stop() {
    running = false;
    waiting.clear();
  }

  private void play(Piece piece) throws InterruptedException {
    if (System.nanoTime() < silentUntil) {
      bell.run();
      return;
    }
    try {
      Pcm pcm = pcm(piece.sound());
      Speaker used = speaker.orElseGet(speakers);
      speaker = Optional.of(used);
      used.play(pcm, piece.volume());
      silentUntil = Long.MIN_VALUE;
    } catch (SilentException e) {
      silent(e.getMessage());
    } catch (LinkageError e) {
      silent("this Java has no sound (java.desktop is missing); use one that has it");
    }
  }

  /** Words reach the ear by another way than sounds: where one is barred, the other may be open. */
  private void speak(String words) throws InterruptedException {
    try {
      if (!words.isEmpty()) {
        voice.say(words);
      }
    } catch (SilentException e) {
      if (!saidOfVoice.equals(e.getMessage())) {
        saidOfVoice = e.getMessage();
        trouble.accept(saidOfVoice);
      }
    }
  }

  /** A file that cannot be read is no reason for silence. */
  private Pcm pcm(Sound sound) {
    try {
      return sound.load();
    } catch (SilentException e) {
      say(e.getMessage() + "; " + Tone.BEEP.id() + " is played instead");
      return Tone.BEEP.sound();
    }
  }

  private void silent(String reason) {
    say(reason);
    silentUntil = System.nanoTime() + RETRY_NANOS;
    bell.run();
  }

  private void say(String reason) {
    if (!reason.equals(said)) {
      said = reason;
      trouble.accept(reason);
    }
  }

  private record Piece(String who, Sound sound, double volume, String words) {}
}
