/**
 * Joins the wire, discovery, endpoints and sockets to a participant, and gives it its two threads: which of our ends
 * hear of which others, and who is told.
 */
package org.robotui.rtps.internal.participant;
