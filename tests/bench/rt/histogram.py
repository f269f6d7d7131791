"""Durations in the buckets of the link (rt-native/link, histogram.h): four an octave, from 64 ns."""

from building import CannotMeasure

BUCKETS = 96


def lower(bucket):
    return (4 + bucket % 4) << (4 + bucket // 4)


def bucket_of(ns):
    if ns < lower(1):
        return 0
    octave = ns.bit_length() - 1
    return min((octave - 6) * 4 + ((ns >> (octave - 2)) & 3), BUCKETS - 1)


class Histogram:
    """Two that are compared have the same buckets, however finely a peer counted."""

    def __init__(self, counts):
        self.counts = counts
        self.total = sum(counts)

    @classmethod
    def of(cls, counted):
        """From pairs of nanoseconds and how often they came."""
        counts = [0] * BUCKETS
        for ns, count in counted:
            counts[bucket_of(max(0, ns))] += count
        return cls(counts)

    def percentile(self, share):
        """Nanoseconds, as if the values of a bucket were spread evenly in it."""
        if self.total == 0:
            raise CannotMeasure("nothing was counted")
        rank, before = share * self.total, 0
        for bucket, count in enumerate(self.counts):
            if count and before + count >= rank:
                begin = lower(bucket) if bucket else 0
                return begin + (lower(bucket + 1) - begin) * (rank - before) / count
            before += count
        return float(self.longest())

    def longest(self):
        """The end of the last bucket that is not empty."""
        last = max((bucket for bucket, count in enumerate(self.counts) if count), default=-1)
        return lower(last + 1) if last >= 0 else 0
