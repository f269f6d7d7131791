package org.robotui.rtps;

/**
 * What a writer counted since it was opened.
 *
 * @param written samples that were written
 * @param writtenBytes their payloads
 * @param refused samples that were not, as a history that keeps all was full
 * @param unacknowledged samples that left the history before all reliable readers had acknowledged them
 * @param repaired samples and fragments that were sent again
 * @param held samples in the history now
 * @param heldBytes their payloads
 */
public record WriterStatistics(long written, long writtenBytes, long refused, long unacknowledged, long repaired,
    int held, long heldBytes) {}
