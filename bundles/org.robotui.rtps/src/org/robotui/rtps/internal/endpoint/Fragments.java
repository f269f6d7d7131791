package org.robotui.rtps.internal.endpoint;

import java.nio.ByteBuffer;

/**
 * Neighbouring fragments of a sample, as one submessage brings them.
 *
 * @param first the number of the first one, from 1 on
 * @param count how many they are, from 1 on
 * @param size of each fragment but the last of the sample
 * @param sampleSize the bytes of the whole sample
 * @param about the sample without its payload
 * @param bytes of the fragments; they are copied
 */
public record Fragments(long first, int count, int size, long sampleSize, Change about, ByteBuffer bytes) {}
