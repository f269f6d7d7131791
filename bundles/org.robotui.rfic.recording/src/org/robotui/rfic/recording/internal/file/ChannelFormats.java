package org.robotui.rfic.recording.internal.file;

import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.HashMap;
import java.util.Map;
import org.robotui.message.lcm.LcmFormat;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.message.payload.PayloadSource;
import org.robotui.message.roblets.RobletFormat;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedSchema;

/** Finds out how the messages of channels are read. For one thread. */
public final class ChannelFormats {
  private static final String PROTOBUF = "protobuf";

  private record Key(RecordedSchema schema, String encoding, String fingerprint) {}

  private final PayloadFormats formats;
  private final Map<Key, PayloadFormat> known = new HashMap<>();

  /**
   * Knows nothing yet.
   *
   * @param formats knows encodings
   */
  public ChannelFormats(PayloadFormats formats) {
    this.formats = formats;
  }

  /**
   * How messages are read.
   *
   * @param channel of a recording
   * @return the same for channels of one type
   */
  public PayloadFormat of(RecordedChannel channel) {
    Key key = new Key(channel.schema(), channel.messageEncoding(), channel.metadata().getOrDefault("fingerprint", ""));
    return known.computeIfAbsent(key, this::made);
  }

  private PayloadFormat made(Key key) {
    byte[] definition = key.schema().definition();
    String text = key.encoding().equals(PROTOBUF) ? Base64.getEncoder().encodeToString(definition)
        : new String(definition, StandardCharsets.UTF_8);
    return switch (key.encoding()) {
      case LcmFormat.ENCODING -> LcmFormat.of(key.schema().name(), text, key.fingerprint());
      case RobletFormat.ENCODING -> RobletFormat.of(key.schema().name(), text);
      default -> formats.of(new PayloadSource(key.encoding(), key.schema().name(), key.schema().encoding(), text));
    };
  }
}
