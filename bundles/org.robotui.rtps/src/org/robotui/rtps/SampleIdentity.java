package org.robotui.rtps;

/**
 * Names one sample in the whole domain. A reply carries that of its request.
 *
 * @param writer who wrote it
 * @param sequence its number at that writer, from 1 on
 */
public record SampleIdentity(Guid writer, long sequence) {}
