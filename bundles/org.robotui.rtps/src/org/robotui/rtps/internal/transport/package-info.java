/**
 * Datagrams: which addresses and ports of this machine are used, which address of a peer is chosen, and the sockets.
 */
package org.robotui.rtps.internal.transport;
