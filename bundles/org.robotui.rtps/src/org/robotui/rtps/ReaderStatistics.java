package org.robotui.rtps;

/**
 * What a reader counted since it was opened.
 *
 * @param received samples that were given to the listener
 * @param receivedBytes their payloads
 * @param lost samples that never came, by the writers' numbers: of best effort writers those between two that came, of
 * reliable ones those that the writer no longer had, or for which the memory did not suffice
 * @param incomplete samples that were given up because fragments of them never came
 * @param damaged submessages that contradict themselves or each other
 * @param deadlinesMissed how often a writer sent nothing for longer than the deadline that this reader requests
 * @param livelinessLost how often a writer did not say in time that it is alive
 * @param listenerErrors calls of the listener that threw
 */
public record ReaderStatistics(long received, long receivedBytes, long lost, long incomplete, long damaged,
    long deadlinesMissed, long livelinessLost, long listenerErrors) {}
