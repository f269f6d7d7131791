package org.robotui.recording.internal.codec;

import java.util.Optional;

/**
 * What came out of a decompression.
 *
 * @param bytes what holds them
 * @param from where they begin
 * @param length how many of them there are
 * @param problem why there are not more, where there should be
 */
public record Decoded(byte[] bytes, int from, int length, Optional<String> problem) {}
