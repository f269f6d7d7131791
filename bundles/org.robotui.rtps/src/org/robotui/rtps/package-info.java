/**
 * RTPS 2.3 in Java, the wire protocol of DDS: participants, writers and readers over UDP, and what others have.
 *
 * <p>Bytes come from peers and are not trusted: memory and time that they cost are bounded, what is lost or damaged is
 * counted and told with its reason, and nonsense of one peer hurts that peer alone.
 *
 * <p>Usable alone: it needs {@code org.robotui.net}, what the protocol libraries share, and SLF4J.
 *
 * <p>Sources: "The Real-time Publish-Subscribe Protocol DDS Interoperability Wire Protocol", version 2.3, and "Data
 * Distribution Service", version 1.4, of the OMG.
 */
package org.robotui.rtps;
