export default function Results({ run }: { run: string }) {
  return <p>Results {run}</p>;
}
