package org.robotui.lcm;

/**
 * What a connection counted since it was opened.
 *
 * @param received messages that came for a subscription
 * @param receivedBytes their bytes, without names and headers
 * @param published messages that were sent
 * @param publishedBytes their bytes
 * @param lost messages of any channel that others sent and that never came, by the gaps in the senders' numbers
 * @param incomplete messages that were given up because fragments of them never came
 * @param damaged datagrams, messages or bytes of a log that are none, and messages above the limits
 * @param dropped messages that were complete and that full queues of subscriptions dropped
 * @param listenerErrors calls of listeners that threw
 * @param receiveBufferWanted the receive buffer that the kernel was asked for, in bytes; 0 where there is none
 * @param receiveBuffer the one it granted
 * @param lastDamage why the last damaged one was refused, for a user to read; empty if there was none
 */
public record LcmStatistics(long received, long receivedBytes, long published, long publishedBytes, long lost,
    long incomplete, long damaged,
    long dropped, long listenerErrors, int receiveBufferWanted, int receiveBuffer, String lastDamage) {}
