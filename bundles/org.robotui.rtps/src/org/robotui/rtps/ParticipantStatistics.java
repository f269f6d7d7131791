package org.robotui.rtps;

/**
 * What a participant counted since it was opened.
 *
 * @param datagrams datagrams that came
 * @param datagramBytes their bytes
 * @param damaged those that are no RTPS, or contradict themselves
 * @param ignored those of participants that do not concern us: other domains, our own announcements
 * @param sent datagrams that were sent
 * @param notSent those that the network did not take
 * @param receiveBuffer the smallest receive buffer that the system granted to one of the sockets, in bytes
 * @param lastDamage why the last damaged one was refused, and from whom it was; empty if there was none
 */
public record ParticipantStatistics(long datagrams, long datagramBytes, long damaged, long ignored, long sent,
    long notSent, int receiveBuffer, String lastDamage) {}
