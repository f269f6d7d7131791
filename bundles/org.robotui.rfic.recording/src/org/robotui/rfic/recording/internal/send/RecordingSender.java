package org.robotui.rfic.recording.internal.send;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ThreadFactory;
import java.util.stream.Collectors;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingPart;
import org.robotui.recording.RecordingReader;

/** Sends the messages of a recording at the distances at which they were recorded. For one thread. */
public final class RecordingSender implements AutoCloseable {
  /** Those into which messages can be sent, for users. */
  public static final String FRAMEWORKS = "ROS 1, ROS 2, LCM and Player";

  private static final long TICK_NANOS = 10_000_000L;

  private final RecordingReader recording;
  private final RecordingInterval interval;
  private final Map<Integer, FrameworkSender> byChannel;
  private final Set<String> left;
  private final SendTime time;
  private long told;

  RecordingSender(RecordingReader recording, RecordingInterval interval, Map<Integer, FrameworkSender> byChannel,
      Set<String> left, SendTime time) {
    this.recording = recording;
    this.interval = interval;
    this.byChannel = byChannel;
    this.left = left;
    this.time = time;
  }

  /**
   * Announces all topics of a part of a recording in the frameworks that they are of.
   *
   * @param recording is read; to be closed by who opened it
   * @param part what of it
   * @param clock whether the time of the recording is said as well
   * @param variables of the environment, which say where the frameworks are
   * @param threads makes all threads
   * @return sends it
   * @throws IOException where a framework is not there, or nothing can be sent; the message says what to do
   * @throws InterruptedException where the thread was interrupted
   */
  public static RecordingSender open(RecordingReader recording, RecordingPart part, boolean clock,
      Map<String, String> variables, ThreadFactory threads) throws IOException, InterruptedException {
    Map<String, List<RecordedChannel>> byEncoding = recording.channels().stream().filter(part.channels())
        .collect(Collectors.groupingBy(RecordedChannel::messageEncoding));
    Map<Integer, FrameworkSender> senders = new HashMap<>();
    try {
      Set<String> left = new TreeSet<>();
      for (Map.Entry<String, List<RecordedChannel>> each : byEncoding.entrySet()) {
        Optional<FrameworkSender> sender = sender(recording, each, clock, variables, threads);
        sender.ifPresent(made -> each.getValue().forEach(channel -> senders.put(channel.id(), made)));
        if (sender.isEmpty()) {
          each.getValue().forEach(channel -> left.add(channel.topic() + " (" + each.getKey() + ")"));
        }
      }
      if (senders.isEmpty()) {
        throw new IOException("there is nothing that can be sent: messages of " + FRAMEWORKS + " can"
            + (left.isEmpty() ? "" : ", here are " + String.join(", ", left)));
      }
      RecordingInterval span = recording.span().orElse(part.interval());
      RecordingInterval played = new RecordingInterval(Math.max(span.start(), part.interval().start()),
          Math.min(span.end(), part.interval().end()));
      return new RecordingSender(recording, played, senders, left, SendTime.REAL);
    } catch (IOException | InterruptedException | RuntimeException e) {
      senders.values().stream().distinct().forEach(FrameworkSender::close);
      throw e;
    }
  }

  private static Optional<FrameworkSender> sender(RecordingReader recording,
      Map.Entry<String, List<RecordedChannel>> sent, boolean clock, Map<String, String> variables,
      ThreadFactory threads) throws IOException, InterruptedException {
    List<RecordedChannel> channels = sent.getValue();
    return switch (sent.getKey()) {
      case Ros1Sender.ENCODING -> Optional.of(Ros1Sender.open(channels, clock, variables, threads));
      case LcmSender.ENCODING -> Optional.of(LcmSender.open(variables, threads));
      case Ros2Sender.ENCODING -> Optional.of(Ros2Sender.open(channels, clock, variables, threads));
      case PlayerSender.ENCODING -> Optional.of(PlayerSender.open(recording, channels, variables, threads));
      default -> Optional.empty();
    };
  }

  /**
   * Where clients have to connect to, for users.
   *
   * @return such as the address of a server with what it has; nothing where they meet elsewhere
   */
  public List<String> places() {
    return senders().stream().flatMap(each -> each.places().stream()).toList();
  }

  /**
   * What cannot be sent.
   *
   * @return topics with their encodings, sorted
   */
  public Set<String> left() {
    return left;
  }

  /**
   * Sends it. Ends early where the thread is interrupted.
   *
   * @param pace how
   * @return how many messages were sent
   * @throws IOException where the recording cannot be read or a message cannot be sent any more
   */
  public long send(SendPace pace) throws IOException {
    long sent = 0;
    try {
      if (!pace.delay().isZero()) {
        time.pass(pace.delay().toNanos());
      }
      while (pace.waits() && !senders().stream().allMatch(FrameworkSender::isHeard)) {
        time.pass(TICK_NANOS);
      }
      sent += held();
      do {
        sent += once(pace.rate());
      } while (pace.loop());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return sent;
    }
    senders().forEach(FrameworkSender::finish);
    return sent;
  }

  private List<FrameworkSender> senders() {
    return byChannel.values().stream().distinct().toList();
  }

  /** What holds at the beginning, such as a map. */
  private long held() throws IOException {
    List<RecordedMessage> all = new ArrayList<>();
    for (RecordedChannel each : recording.channels()) {
      if (byChannel.containsKey(each.id()) && each.isLatched()) {
        recording.latestBefore(each.id(), interval.start() - 1).ifPresent(all::add);
      }
    }
    all.sort(Comparator.comparingLong(RecordedMessage::logTime));
    for (RecordedMessage each : all) {
      byChannel.get(each.channel().id()).send(each);
    }
    return all.size();
  }

  private long once(double rate) throws IOException, InterruptedException {
    long begin = time.nanos();
    long sent = 0;
    RecordingCursor cursor = recording.cursor(interval, byChannel.keySet());
    tick(interval.start());
    for (Optional<RecordedMessage> next = cursor.next(); next.isPresent(); next = cursor.next()) {
      RecordedMessage message = next.get();
      await(begin, message.logTime(), rate);
      byChannel.get(message.channel().id()).send(message);
      sent++;
    }
    tick(interval.end());
    return sent;
  }

  /** Waits until it is the turn of a time, and says meanwhile what time it is. */
  private void await(long begin, long until, double rate) throws InterruptedException {
    long due = begin + Math.round((until - interval.start()) / rate);
    for (long now = time.nanos(); now < due; now = time.nanos()) {
      time.pass(Math.max(1, Math.min(due, told + TICK_NANOS) - now));
      if (time.nanos() - told >= TICK_NANOS) {
        tick(Math.min(until, interval.start() + Math.round((time.nanos() - begin) * rate)));
      }
    }
    if (Thread.interrupted()) {
      throw new InterruptedException();
    }
  }

  private void tick(long now) {
    told = time.nanos();
    senders().forEach(each -> each.clock(now));
  }

  @Override
  public void close() {
    senders().forEach(FrameworkSender::close);
  }
}
