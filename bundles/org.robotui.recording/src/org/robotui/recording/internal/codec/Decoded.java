package org.robotui.recording.internal.codec;

import java.util.Optional;

/**
 * What came out of a decompression.
 *
 * @param bytes begin at 0
 * @param length how many of them there are
 * @param problem why there are not more, where there should be
 */
public record Decoded(byte[] bytes, int length, Optional<String> problem) {}
